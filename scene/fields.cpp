// fields.cpp: strict reading of one table of a scene file.
#include "scene/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/words.h"

namespace litmus {
namespace {

constexpr std::string_view kThreeNumbers = "three finite numbers [x, y, z]";
constexpr std::string_view kDirection = "three finite numbers [x, y, z], not all 0";
constexpr std::string_view kColor =
    "a number >= 0, [r, g, b], each >= 0, linear RGB, or a spectrum's name";

double longest_component(const Vector& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// NaN if the node is no number.
double as_number(const Node& node) {
  if (const auto* integer = std::get_if<std::int64_t>(&node.value)) return double(*integer);
  if (const auto* number = std::get_if<double>(&node.value)) return *number;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

bool Range::holds(double value) const {
  return (low_allowed ? value >= low : value > low) &&
         (high_allowed ? value <= high : value < high);
}

bool nearly_parallel(const Vector& a, const Vector& b) {
  const Vector u = glm::normalize(a / longest_component(a));
  const Vector v = glm::normalize(b / longest_component(b));
  return !(glm::length(glm::cross(u, v)) > 1e-9);
}

bool normalizable(const Vector& vector) {
  const double length = longest_component(vector);
  return length >= kShortestVector && length <= kLongestVector;
}

Fields::Fields(const std::filesystem::path& file, const Node& node, std::string what)
    : file_(&file), node_(&node), table_(std::get_if<Node::Table>(&node.value)), what_(what) {
  if (!table_) litmus::refuse(file, node.at, what, "must be a table, not " + shown(node));
}

void Fields::only(std::initializer_list<std::string_view> keys) const {
  for (const Entry& entry : *table_) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    const std::vector<std::string> names(keys.begin(), keys.end());
    litmus::refuse(
        *file_, entry.at, entry.key,
        fmt::format("unknown key in {}{} Allowed: {}", what_,
                    near_words(entry.key, names).empty() ? "." : suggestion(entry.key, names),
                    listed(names)));
  }
}

const Node* Fields::find(std::string_view key) const {
  for (const Entry& entry : *table_)
    if (entry.key == key) return &entry.node;
  return nullptr;
}

Position Fields::place() const { return node_->at; }

Position Fields::place(std::string_view key) const {
  const Node* node = find(key);
  return node ? node->at : node_->at;
}

void Fields::refuse(std::string_view key, const std::string& message) const {
  litmus::refuse(*file_, place(key), std::string(key), message);
}

void Fields::refuse_missing(std::string_view key, std::string_view allowed) const {
  refuse(key, fmt::format("missing in {}; must be {}", what_, allowed));
}

void Fields::refuse_value(std::string_view key, const Node& value, std::string_view allowed) const {
  litmus::refuse(*file_, value.at, std::string(key),
                 fmt::format("must be {}, not {}", allowed, shown(value)));
}

void Fields::refuse_word(std::string_view key, const std::string& word,
                         const std::vector<std::string>& words) const {
  std::vector<std::string> quoted;
  for (const std::string& allowed : words) quoted.push_back('"' + allowed + '"');
  refuse(key, fmt::format("must be {}, not \"{}\"{}", listed(quoted, "or"), word,
                          suggestion(word, words)));
}

const Node& Fields::required(std::string_view key, std::string_view allowed) const {
  const Node* node = find(key);
  if (!node) refuse_missing(key, allowed);
  return *node;
}

double Fields::checked(std::string_view key, const Node& value, const Range& range) const {
  const double number = as_number(value);
  if (!range.holds(number)) refuse_value(key, value, range.text);
  return number;
}

double Fields::number(std::string_view key, const Range& range) const {
  return checked(key, required(key, range.text), range);
}

double Fields::number(std::string_view key, const Range& range, double fallback) const {
  return has(key) ? number(key, range) : fallback;
}

int Fields::integer(std::string_view key, int low, int high) const {
  const std::string allowed = fmt::format("a whole number {}..{}", low, high);
  const Node& node = required(key, allowed);
  const auto* value = std::get_if<std::int64_t>(&node.value);
  if (!value || *value < low || *value > high) refuse_value(key, node, allowed);
  return int(*value);
}

int Fields::integer(std::string_view key, int low, int high, int fallback) const {
  return has(key) ? integer(key, low, high) : fallback;
}

bool Fields::boolean(std::string_view key, bool fallback) const {
  const Node* node = find(key);
  if (!node) return fallback;
  const auto* value = std::get_if<bool>(&node->value);
  if (!value) refuse_value(key, *node, "true or false");
  return *value;
}

std::string Fields::text(std::string_view key) const {
  constexpr std::string_view kAllowed = "a text in quotes";
  const Node& node = required(key, kAllowed);
  const auto* value = std::get_if<std::string>(&node.value);
  if (!value) refuse_value(key, node, kAllowed);
  if (value->empty()) refuse(key, "must not be empty");
  for (const unsigned char c : *value)
    if (c < 0x20 || c == 0x7f)
      refuse(key, fmt::format("must hold no control characters (it has code {})", int(c)));
  return *value;
}

std::string Fields::text(std::string_view key, std::string fallback) const {
  return has(key) ? text(key) : fallback;
}

std::vector<std::string> Fields::texts(std::string_view key) const {
  constexpr std::string_view kAllowed = "a list of texts, such as [\"spot\", \"shadow\"]";
  const Node* node = find(key);
  if (!node) return {};
  const auto* array = std::get_if<Node::Array>(&node->value);
  if (!array) refuse_value(key, *node, kAllowed);
  std::vector<std::string> words;
  for (const Node& element : *array) {
    const auto* word = std::get_if<std::string>(&element.value);
    if (!word || word->empty()) refuse_value(key, element, kAllowed);
    words.push_back(*word);
  }
  return words;
}

Point Fields::point(std::string_view key) const {
  const Node& node = required(key, kThreeNumbers);
  const auto* array = std::get_if<Node::Array>(&node.value);
  if (!array || array->size() != 3) refuse_value(key, node, kThreeNumbers);
  Point point;
  for (int i = 0; i < 3; ++i) point[i] = checked(key, (*array)[std::size_t(i)], kAnyNumber);
  return point;
}

Point Fields::point(std::string_view key, Point fallback) const {
  return has(key) ? point(key) : fallback;
}

Vector Fields::direction(std::string_view key) const {
  if (!has(key)) refuse_missing(key, kDirection);
  const Vector vector = point(key);
  if (vector == Vector(0)) refuse(key, "must not have zero length (it is [0, 0, 0])");
  if (!normalizable(vector))
    refuse_value(key, *find(key), "a vector whose longest component is within 1e-100..1e100");
  return vector;
}

Vector Fields::direction(std::string_view key, Vector fallback) const {
  return has(key) ? direction(key) : fallback;
}

Color Fields::color(std::string_view key, Color fallback) const {
  const Node* node = find(key);
  if (!node) return fallback;
  if (std::holds_alternative<std::string>(node->value)) return fallback;
  const auto* array = std::get_if<Node::Array>(&node->value);
  const Range range{0, true, kColor};
  if (!array) return Color(checked(key, *node, range));
  if (array->size() != 3) refuse_value(key, *node, kColor);
  Color color;
  for (int i = 0; i < 3; ++i) color[i] = checked(key, (*array)[std::size_t(i)], range);
  return color;
}

const Node::Array& Fields::tables(std::string_view key) const {
  static const Node::Array kNone;
  const Node* node = find(key);
  if (!node) return kNone;
  const auto* array = std::get_if<Node::Array>(&node->value);
  if (!array) refuse_value(key, *node, fmt::format("a list of tables, each headed [[{}]]", key));
  return *array;
}

}  // namespace litmus
