// document.cpp: TOML text to a tree of values with positions.
#include "scene/document.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "scene/refusal.h"
#include "scene/words.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

Position position(const toml::source_region& source) {
  return {source.begin.line, source.begin.column};
}

Node convert(const toml::node& from) {
  Node to{position(from.source()), {}};
  if (const auto* boolean = from.as_boolean()) to.value = boolean->get();
  if (const auto* integer = from.as_integer()) to.value = integer->get();
  if (const auto* number = from.as_floating_point()) to.value = number->get();
  if (const auto* string = from.as_string()) to.value = string->get();
  if (const auto* array = from.as_array()) {
    Node::Array elements;
    for (const toml::node& element : *array) elements.push_back(convert(element));
    to.value = std::move(elements);
  }
  if (const auto* table = from.as_table()) {
    Node::Table entries;
    for (const auto& [key, node] : *table)
      entries.push_back({std::string(key.str()), position(key.source()), convert(node)});
    // toml++ sorts by key; people read from the top.
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return std::pair(a.at.line, a.at.column) < std::pair(b.at.line, b.at.column);
    });
    to.value = std::move(entries);
  }
  return to;
}

}  // namespace

void refuse(const fs::path& file, Position at, const std::string& field,
            const std::string& message) {
  throw Refusal(fmt::format("{}:{}:{}: {}: {}", file.string(), at.line, at.column, field, message));
}

std::string read_limited(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) throw std::runtime_error("no such file");
  if (!fs::is_regular_file(status)) throw std::runtime_error("not a regular file");
  const std::uintmax_t bytes = fs::file_size(file, error);
  if (error) throw std::runtime_error("cannot be read: " + error.message());
  if (bytes > kLargestFile)
    throw std::runtime_error(fmt::format("{} bytes, over the limit of 16 MiB", bytes));
  std::ifstream stream(file, std::ios::binary);
  std::string text(bytes, '\0');
  if (!stream.read(text.data(), std::streamsize(bytes))) throw std::runtime_error("cannot be read");
  return text;
}

Node read_document(const fs::path& file) {
  std::string text;
  try {
    text = read_limited(file);
  } catch (const std::runtime_error& error) {
    refuse(file, {}, "file", error.what());
  }
  try {
    return convert(toml::parse(text, file.string()));
  } catch (const toml::parse_error& error) {
    refuse(file, position(error.source()), "TOML", std::string(error.description()));
  }
}

std::string shown(const Node& node) {
  struct Show {
    std::string operator()(std::monostate) const { return "a date or time"; }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const { return number_text(value); }
    std::string operator()(const std::string& value) const {
      const bool short_enough = value.size() <= 60;
      return '"' + (short_enough ? value : value.substr(0, 57) + "...") + '"';
    }
    std::string operator()(const Node::Array& value) const {
      std::string text = "[";
      for (std::size_t i = 0; i < value.size() && i < 4; ++i)
        text += (i ? ", " : "") + shown(value[i]);
      return text + (value.size() > 4 ? ", ...]" : "]");
    }
    std::string operator()(const Node::Table&) const { return "a table"; }
  };
  return std::visit(Show{}, node.value);
}

}  // namespace litmus
