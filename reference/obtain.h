// obtain.h: gets the reference images of many scenes: from the store, from a renderer, or as
// shipped.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reference/drivers.h"
#include "reference/store.h"
#include "scene/picture.h"
#include "scene/scene.h"

namespace litmus {

/// Where reference images may come from.
enum class Sources {
  Auto,    ///< the renderer if it is installed, else the stored images
  Live,    ///< the installed renderer only
  Stored,  ///< the images that ship with litmus only
};

/// "auto", "live" or "stored". Throws Refusal that lists them.
Sources parse_sources(std::string_view word);

struct ObtainOptions {
  Sources sources = Sources::Auto;
  const Store* store = nullptr;         ///< null: render everything, keep nothing
  bool fresh = false;                   ///< render even what the store has, and replace it there
  std::string program_version;          ///< of litmus, part of the store's key
  std::filesystem::path stored_images;  ///< empty: stored_images_directory()
  ReferenceOptions reference;           ///< each driver works in a folder of its own below `work`
};

/// One scene by one reference: images, or why there are none.
struct ObtainedReference {
  std::string scene;      ///< Scene::name
  std::string reference;  ///< Driver::name
  /// The scene's, in its order; of a spectral scene as expected_layers (band_images.h) lists them.
  /// Empty unless `source` is set.
  Layers layers;
  /// "live": rendered by this installation, now or in an earlier run of the same versions.
  /// "stored": as shipped. "": none.
  std::string source;
  bool rendered_now = false;     ///< live, and not taken from the store
  std::string version, command;  ///< of the renderer
  double seconds = 0;            ///< rendering alone, as the renderer reported it
  std::string failure;  ///< the renderer failed or was asked for and is missing: one sentence
  std::string skipped;  ///< nothing to compare with, and nobody to blame: one sentence
  std::string log;      ///< after a failure, the end of the renderer's log
};

/// One result per scene, in order: exactly one of `source`, `failure` and `skipped` is set. What
/// the store lacks is rendered in one batch, and each scene is kept as soon as it is done. A failed
/// live render is a failure, never replaced by a stored image. Pixels are rounded to 32-bit floats,
/// so that a fresh image and one from the store are the same. Several drivers may be asked at once,
/// from different threads. Never throws for what a renderer does.
std::vector<ObtainedReference> obtain(std::span<const Scene> scenes, const Driver& driver,
                                      const ObtainOptions& options);

}  // namespace litmus
