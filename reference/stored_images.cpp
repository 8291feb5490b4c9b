// stored_images.cpp: the shipped reference images and their provenance.
#include "reference/stored_images.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/image_io.h"
#include "compare/whole_file.h"
#include "reference/band_images.h"
#include "reference/hash.h"
#include "scene/load.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kStoredSchema = 1;
constexpr std::string_view kRemedy = "refresh with `litmus run --refresh`";

fs::path file_of(const Scene& scene, std::string_view renderer, const fs::path& folder,
                 std::string_view extension) {
  return folder / scene.name / (std::string(renderer) + std::string(extension));
}

/// What differs where the fingerprints do. Without the CIE's tables a scene is another one than
/// with them, and to refresh its images would make them wrong for everybody else.
std::string made_from_another(const Scene& scene) {
  if (scene.spectra && !scene.spectra->note.empty())
    return fmt::format("it was made with the CIE's table, and here {}", scene.spectra->note);
  return fmt::format("made from another version of this scene: {}", kRemedy);
}

/// Throws, saying what is wrong and the remedy, unless the images are sound and the scene's.
StoredReference read_stored(const Scene& scene, const fs::path& image, const fs::path& about) {
  std::ifstream text(about);
  if (!text) throw Refusal(fmt::format("{} is missing: {}", about.filename().string(), kRemedy));
  const auto meta = Json::parse(text);
  if (meta.at("schema") != kStoredSchema)
    throw Refusal(fmt::format("of another schema: {}", kRemedy));
  if (meta.at("scene_fingerprint") != fingerprint(scene)) throw Refusal(made_from_another(scene));
  if (meta.at("checksum") != hash_file(image))
    throw Refusal(fmt::format("damaged (checksum): {}", kRemedy));

  StoredReference stored;
  stored.layers = read_layers(image);
  if (const auto wrong = misfit(scene, stored.layers); !wrong.empty())
    throw Refusal(fmt::format("{}: {}", wrong, kRemedy));
  stored.version = meta.at("renderer_version");
  stored.command = meta.at("command");
  stored.seconds = meta.at("seconds");
  return stored;
}

}  // namespace

fs::path stored_images_directory() {
  const auto data = data_directory();
  std::error_code error;
  const auto installed = data / "images";
  return fs::is_directory(installed, error) ? installed : data / "reference" / "images";
}

StoredLookup load_stored(const Scene& scene, std::string_view renderer, const fs::path& folder) {
  const auto image = file_of(scene, renderer, folder, ".exr");
  std::error_code error;
  if (!fs::exists(image, error))
    return {std::nullopt, fmt::format("no stored {} image of {}", renderer, scene.name)};
  try {
    return {read_stored(scene, image, file_of(scene, renderer, folder, ".json")), ""};
  } catch (const Refusal& wrong) {
    return {std::nullopt, fmt::format("the stored {} image of {} is not used: {}", renderer,
                                      scene.name, wrong.what())};
  } catch (const std::exception& wrong) {
    return {std::nullopt, fmt::format("the stored {} image of {} is not used: {}: {}", renderer,
                                      scene.name, wrong.what(), kRemedy)};
  }
}

std::string stored_version(const Scene& scene, std::string_view renderer, const fs::path& folder) {
  std::ifstream text(file_of(scene, renderer, folder, ".json"));
  const auto meta = Json::parse(text, nullptr, false);
  if (!meta.is_object() || !meta.contains("renderer_version")) return "";
  const auto& version = meta["renderer_version"];
  return version.is_string() ? version.get<std::string>() : "";
}

void save_stored(const Scene& scene, std::string_view renderer, const StoredReference& images,
                 const fs::path& folder) {
  if (const auto wrong = misfit(scene, images.layers); !wrong.empty())
    throw Refusal(fmt::format("{}: {} image not kept: {}", scene.name, renderer, wrong));
  const auto image = file_of(scene, renderer, folder, ".exr");
  std::error_code error;
  fs::create_directories(image.parent_path(), error);
  if (error) throw Refusal(image.parent_path().string() + ": cannot be made: " + error.message());
  write_layers(image, images.layers);
  const Json meta = {{"schema", kStoredSchema},
                     {"scene", scene.name},
                     {"scene_fingerprint", fingerprint(scene)},
                     {"renderer", renderer},
                     {"renderer_version", images.version},
                     {"command", images.command},
                     {"seconds", images.seconds},
                     {"checksum", hash_file(image)}};
  write_whole(file_of(scene, renderer, folder, ".json"),
              meta.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string misfit(const Scene& scene, const Layers& layers) {
  const Layers expected = expected_layers(scene);
  if (layers.size() != expected.size())
    return fmt::format("{} layers where the scene has {}", layers.size(), expected.size());
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const auto& [light, type, picture] = layers[i];
    if (light != expected[i].light || type != expected[i].light_type)
      return fmt::format("layer {} is {} ({}) where the scene has {} ({})", i, light, type,
                         expected[i].light, expected[i].light_type);
    if (picture.width != scene.width || picture.height != scene.height)
      return fmt::format("layer {} is {} x {} pixels where the scene has {} x {}", light,
                         picture.width, picture.height, scene.width, scene.height);
  }
  return {};
}

}  // namespace litmus
