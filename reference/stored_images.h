// stored_images.h: the reference images that ship with litmus, for machines without a renderer.
//
// FOLDER/SCENE/RENDERER.exr holds one part per layer, RENDERER.json says what made it. Images of
// another version of the scene, or with another checksum, are refused, never used.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "scene/picture.h"
#include "scene/scene.h"

namespace litmus {

struct StoredReference {
  Layers layers;
  std::string version;  ///< of the renderer
  std::string command;
  double seconds = 0;  ///< rendering all layers, as the renderer reported it
};

struct StoredLookup {
  std::optional<StoredReference> images;
  std::string reason;  ///< why there are none, and the remedy; empty if there are
};

/// data_directory()/reference/images in a source tree, data_directory()/images once installed.
std::filesystem::path stored_images_directory();

/// The stored images of a scene by a renderer (a Driver::name). Never throws for what it finds.
StoredLookup load_stored(const Scene& scene, std::string_view renderer,
                         const std::filesystem::path& folder = stored_images_directory());

/// The version of the renderer that made them, without reading the images; empty if there are none.
std::string stored_version(const Scene& scene, std::string_view renderer,
                           const std::filesystem::path& folder = stored_images_directory());

/// Writes or replaces them. A process killed in between leaves images that load_stored refuses.
/// Throws Refusal if they cannot be written, or if the layers are not the scene's.
void save_stored(const Scene& scene, std::string_view renderer, const StoredReference& images,
                 const std::filesystem::path& folder = stored_images_directory());

/// Empty if these are the scene's layers (expected_layers of band_images.h), all of the scene's
/// size; else what differs.
std::string misfit(const Scene& scene, const Layers& layers);

}  // namespace litmus
