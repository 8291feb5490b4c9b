// candidates_file.cpp: litmus.toml to candidates, strictly.
#include "reference/candidates_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/document.h"
#include "scene/fields.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;

/// Names that rows of a report have already.
constexpr std::array<std::string_view, 6> kTaken{"litmus",        "povray",         "blender",
                                                 "povray-native", "blender-native", "all"};

std::string read_name(const Fields& fields, const std::vector<Candidate>& others) {
  const std::string name = fields.text("name");
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  });
  if (!plain || name.front() == '.' || name.size() > 60)
    fields.refuse("name", fmt::format("must be at most 60 letters, digits, '-', '_' and '.', the "
                                      "first no dot, not \"{}\"",
                                      name));
  if (std::find(kTaken.begin(), kTaken.end(), name) != kTaken.end())
    fields.refuse("name",
                  fmt::format("\"{}\" has a meaning in reports; choose another name", name));
  for (const Candidate& other : others)
    if (other.name == name)
      fields.refuse("name", fmt::format("\"{}\" is the name of an earlier candidate; names must "
                                        "differ",
                                        name));
  return name;
}

Encoding read_encoding(const Fields& fields) {
  Encoding encoding;
  if (fields.has("encoding"))
    encoding = fields.choice<Encoding>(
        "encoding", {kEncodings[0], kEncodings[1], kEncodings[2], kEncodings[3], kEncodings[4]});
  constexpr Range kExposure{1e-6, true, "a number within 1e-6..1e6", 1e6, true};
  encoding.exposure = fields.number("exposure", kExposure, 1);
  return encoding;
}

std::vector<std::string> read_command(const Fields& fields) {
  std::vector<std::string> command = fields.texts("command");
  if (command.empty())
    fields.refuse("command",
                  "must name a program, as in [\"./my-tracer\", \"{scene}\", \"{light}\", "
                  "\"{output}.pfm\"]");
  for (const char* word : {"{scene}", "{light}", "{output}"})
    if (std::none_of(command.begin(), command.end(), [&](const std::string& argument) {
          return argument.find(word) != std::string::npos;
        }))
      fields.refuse("command", fmt::format("must mention {}: the program is called once for each "
                                           "light of each scene",
                                           word));
  return command;
}

fs::path read_images(const Fields& fields, const fs::path& folder) {
  const fs::path images = folder / fields.text("images");
  std::error_code error;
  if (!fs::is_directory(images, error))
    fields.refuse("images", fmt::format("there is no folder {}; it holds SCENE/LIGHT.exr, .pfm or "
                                        ".png",
                                        images.string()));
  return images;
}

Candidate read_candidate(const Fields& fields, const std::vector<Candidate>& others) {
  Candidate candidate;
  candidate.folder = fs::absolute(fields.file()).parent_path();
  candidate.name = read_name(fields, others);
  if (fields.has("command") == fields.has("images"))
    fields.refuse(fields.has("images") ? "images" : "command",
                  "a candidate has either a command or a folder of images");
  if (fields.has("command")) {
    fields.only({"name", "command", "encoding", "exposure", "time_limit", "expect"});
    candidate.command = read_command(fields);
    if (fields.has("time_limit"))
      candidate.time_limit = std::chrono::seconds(fields.integer("time_limit", 1, 86400));
  } else {
    fields.only({"name", "images", "encoding", "exposure", "expect"});
    candidate.images = read_images(fields, candidate.folder);
  }
  candidate.encoding = read_encoding(fields);
  if (fields.has("expect"))
    candidate.expected_to_differ =
        fields.choice<bool>("expect", {{"equal", false}, {"differs", true}});
  return candidate;
}

}  // namespace

std::vector<Candidate> load_candidates(const fs::path& file) {
  const Node document = read_document(file);
  const Fields root(file, document, "a list of candidates");
  root.only({"candidate"});
  std::vector<Candidate> candidates;
  for (const Node& node : root.tables("candidate"))
    candidates.push_back(read_candidate(Fields(file, node, "a candidate"), candidates));
  if (candidates.empty())
    root.refuse_missing("candidate", "a table headed [[candidate]], with a name and a command");
  return candidates;
}

}  // namespace litmus
