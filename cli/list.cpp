// list.cpp: litmus list, the canonical scenes.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "scene/expect.h"
#include "scene/load.h"
#include "scene/observer.h"

namespace litmus {
namespace {

std::vector<std::string> light_types(const Scene& scene) {
  std::vector<std::string> types;
  for (const Light& light : scene.lights) {
    const std::string type(light_type(light));
    if (std::find(types.begin(), types.end(), type) == types.end()) types.push_back(type);
  }
  return types;
}

std::vector<std::string> oracles_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const Oracle oracle : scene.expect) names.emplace_back(name_of(oracle));
  return names;
}

void print_json(const std::vector<Scene>& scenes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Scene& scene : scenes) {
    list.push_back({{"name", scene.name},
                    {"about", scene.about},
                    {"light_types", light_types(scene)},
                    {"tags", scene.tags},
                    {"oracles", oracles_of(scene)},
                    {"file", scene.file.string()}});
  }
  std::cout << list.dump(2) << '\n';
}

void print_table(const std::vector<Scene>& scenes) {
  for (const Scene& scene : scenes) {
    std::cout << fmt::format("{:<26} {:<28} {}\n{:<26} {}\n", scene.name,
                             fmt::format("{}", fmt::join(light_types(scene), ", ")),
                             fmt::join(scene.tags, ", "), "", scene.about);
    if (!scene.expect.empty())
      std::cout << fmt::format("{:<26} closed forms: {}\n", "", fmt::join(oracles_of(scene), ", "));
  }
}

int run_list(bool json, const std::string& tag) {
  auto [scenes, left_out] = load_canonical_scenes();
  for (const std::string& why : left_out) std::cerr << "warning: left out: " << why << '\n';
  if (!tag.empty())
    std::erase_if(scenes, [&](const Scene& scene) {
      return std::find(scene.tags.begin(), scene.tags.end(), tag) == scene.tags.end();
    });
  json ? print_json(scenes) : print_table(scenes);
  return kPass;
}

}  // namespace

void add_list(Program& program) {
  auto json = std::make_shared<bool>(false);
  auto tag = std::make_shared<std::string>();
  Subcommand command = program.add("list", "List the canonical scenes");
  command.flag("--json", *json, "For machines: name, about, light_types, tags, oracles, file");
  command.option("--tag", *tag, "Only scenes with this tag");
  command.footer("Example: litmus list --tag shadow");
  command.on_run([json, tag] { return run_list(*json, *tag); });
}

}  // namespace litmus
