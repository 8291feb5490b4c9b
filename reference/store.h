// store.h: the content-addressed store of reference images, one entry per layer of a scene.
//
// An entry is a folder ROOT/2 hex digits/30 hex digits/ with image.exr (one layer) and meta.json
// (the key's parts, provenance, and the checksum of the image). It is made under a temporary name,
// flushed to the disk and renamed into place, so it is there whole or not at all. An entry whose
// checksum, key or picture is not right is set aside as .damaged-..., with a warning, and counts as
// missing. Any number of processes may use one store at once.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "scene/picture.h"

namespace litmus {

/// Everything that decides an image. Any difference makes another entry.
struct StoreKey {
  std::string scene;             ///< fingerprint(scene)
  int layer = 0;                 ///< 0 is the ambient layer, i is the scene's light i - 1
  std::string light;             ///< the layer's name
  std::string reference;         ///< Driver::name
  int revision = 0;              ///< Driver::revision
  std::string source;            ///< hash_text(Driver::source(scene))
  std::string renderer_version;  ///< Installation::version
  std::string program_version;   ///< of litmus
};

/// 32 hexadecimal digits.
std::string hash(const StoreKey& key);

struct StoreEntry {
  Layer layer;
  double seconds = 0;   ///< rendering all layers of the scene, as the renderer reports it
  std::string command;  ///< that made it
};

struct Store {
  std::filesystem::path root;
  std::function<void(const std::string&)>
      warn;  ///< one sentence; may be empty; any thread calls it
};

/// $XDG_CACHE_HOME/litmus, else ~/.cache/litmus, else (no home) the user's own folder of temporary files.
std::filesystem::path default_store_directory();

/// Makes the folder if missing and removes what killed processes left half made. Throws Refusal if
/// it cannot be made or written.
Store open_store(const std::filesystem::path& root,
                 std::function<void(const std::string&)> warn = {});

/// The entry if it is there and sound; its pixels are exactly those that were saved, rounded to
/// 32-bit floats.
std::optional<StoreEntry> find(const Store& store, const StoreKey& key);

/// Keeps an entry; one of the same key is replaced at once. Throws Refusal if it cannot be written.
void save(const Store& store, const StoreKey& key, const StoreEntry& entry);

}  // namespace litmus
