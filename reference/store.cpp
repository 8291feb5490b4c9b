// store.cpp: entries that are whole or absent, whatever kills the process that writes them.
#include "reference/store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "compare/image_io.h"
#include "compare/whole_file.h"
#include "reference/hash.h"
#include "scene/refusal.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;
constexpr std::string_view kTemporary = ".tmp-";
constexpr std::string_view kDamaged = ".damaged-";

/// An open folder, which stays the same one whatever is renamed.
struct Folder {
  int descriptor = -1;
  explicit Folder(const fs::path& path)
      : descriptor(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {}
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    if (descriptor >= 0) ::close(descriptor);
  }
  explicit operator bool() const { return descriptor >= 0; }
  /// Whether `path` still leads to this folder.
  bool is_at(const fs::path& path) const {
    struct stat here {
    }, there{};
    return ::fstat(descriptor, &here) == 0 && ::stat(path.c_str(), &there) == 0 &&
           here.st_ino == there.st_ino && here.st_dev == there.st_dev;
  }
};

fs::path place_of(const Store& store, const StoreKey& key) {
  const auto digits = hash(key);
  return store.root / digits.substr(0, 2) / digits.substr(2);
}

void warn(const Store& store, const std::string& text) {
  if (store.warn) store.warn(text);
}

Json to_json(const StoreKey& key) {
  return {{"scene", key.scene},
          {"layer", key.layer},
          {"light", key.light},
          {"reference", key.reference},
          {"revision", key.revision},
          {"source", key.source},
          {"renderer_version", key.renderer_version},
          {"program_version", key.program_version}};
}

Json description(const StoreKey& key, const StoreEntry& entry, const fs::path& image) {
  return {{"schema", kSchema},
          {"key", to_json(key)},
          {"light_type", entry.layer.light_type},
          {"width", entry.layer.picture.width},
          {"height", entry.layer.picture.height},
          {"seconds", entry.seconds},
          {"command", entry.command},
          {"bytes", fs::file_size(image)},
          {"checksum", hash_file(image)}};
}

/// Reads a whole entry. Throws, saying what is wrong, unless everything in it is right.
StoreEntry read_entry(const fs::path& place, const StoreKey& key) {
  std::ifstream text(place / "meta.json");
  if (!text) throw Refusal("meta.json is missing");
  const auto meta = Json::parse(text);
  if (meta.at("schema") != kSchema) throw Refusal("another schema");
  if (meta.at("key") != to_json(key)) throw Refusal("it was made for another key");

  const auto image = place / "image.exr";
  if (meta.at("checksum") != hash_file(image)) throw Refusal("the checksum of image.exr differs");
  auto layers = read_layers(image);
  if (layers.size() != 1 || layers[0].light != key.light)
    throw Refusal("image.exr is another layer");

  StoreEntry entry;
  entry.layer = std::move(layers[0]);
  entry.layer.light_type = meta.at("light_type");
  entry.seconds = meta.at("seconds");
  entry.command = meta.at("command");
  return entry;
}

void set_aside(const Store& store, const fs::path& place, const std::string& why) {
  auto aside = fmt::format("{}{}-XXXXXX", kDamaged, place.filename().string());
  aside = (place.parent_path() / aside).string();
  // An empty folder of a new name: renaming onto it replaces it.
  if (!::mkdtemp(aside.data())) return warn(store, place.string() + ": damaged: " + why);
  if (::rename(place.c_str(), aside.c_str()) != 0) {
    ::rmdir(aside.c_str());  // somebody else was faster
    return;
  }
  warn(store, fmt::format("{}: damaged ({}): set aside as {} and made again", place.string(), why,
                          fs::path(aside).filename().string()));
}

/// A temporary folder for one entry, locked as long as its maker lives.
struct Draft {
  fs::path path;
  std::optional<Folder> lock;

  explicit Draft(const fs::path& parent) {
    for (int attempt = 0; attempt < 10; ++attempt) {
      auto name = (parent / (std::string(kTemporary) + "XXXXXX")).string();
      if (!::mkdtemp(name.data())) break;
      path = name;
      lock.emplace(path);
      // A sweep between the two lines may have taken it for abandoned: then it is gone.
      if (*lock && ::flock(lock->descriptor, LOCK_EX) == 0 && lock->is_at(path)) return;
    }
    throw Refusal(fmt::format("{}: cannot be written: {}", parent.string(), std::strerror(errno)));
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft() {
    std::error_code error;
    fs::remove_all(path, error);  // what the entry replaced, or what failed
  }
};

/// Flushes a folder's list of names.
void flush(const Folder& folder) {
  if (folder) ::fsync(folder.descriptor);
}

/// Renames the draft to `place`. An entry that is there changes places with it, so that there is
/// one at every moment, and goes with the draft.
void put_in_place(const Draft& draft, const fs::path& place) {
  for (int attempt = 0; attempt < 10; ++attempt) {
    if (::rename(draft.path.c_str(), place.c_str()) == 0) return;
    if (errno != EEXIST && errno != ENOTEMPTY) break;
    if (::renameat2(AT_FDCWD, draft.path.c_str(), AT_FDCWD, place.c_str(), RENAME_EXCHANGE) == 0)
      return;
    if (errno == ENOENT) continue;  // it was there a moment ago
    // A file system without exchange: make room first.
    std::error_code error;
    const auto old = draft.path.string() + "-old";
    fs::rename(place, old, error);
    fs::remove_all(old, error);
  }
  throw Refusal(fmt::format("{}: cannot be written: {}", place.string(), std::strerror(errno)));
}

/// Removes the temporary folders whose makers are gone: nobody holds their lock.
void sweep(const fs::path& root) {
  std::error_code error;
  for (const auto& two : fs::directory_iterator(root, error)) {
    if (two.path().filename().string().size() != 2) continue;
    for (const auto& entry : fs::directory_iterator(two.path(), error)) {
      if (!entry.path().filename().string().starts_with(kTemporary)) continue;
      const Folder folder(entry.path());
      if (folder && ::flock(folder.descriptor, LOCK_EX | LOCK_NB) == 0)
        fs::remove_all(entry.path(), error);
    }
  }
}

}  // namespace

std::string hash(const StoreKey& key) { return hash_text(to_json(key).dump()); }

fs::path default_store_directory() {
  // The XDG base directory specification: a relative path counts as unset.
  const char* cache = std::getenv("XDG_CACHE_HOME");
  if (cache && *cache == '/') return fs::path(cache) / "litmus";
  const char* home = std::getenv("HOME");
  if (home && *home) return fs::path(home) / ".cache" / "litmus";
  return fs::temp_directory_path() / fmt::format("litmus-{}", ::getuid());
}

Store open_store(const fs::path& root, std::function<void(const std::string&)> warn) {
  std::error_code error;
  fs::create_directories(root, error);
  if (!fs::is_directory(root) || ::access(root.c_str(), W_OK | X_OK) != 0)
    throw Refusal(root.string() + ": the store cannot be written there; name another with --store");
  sweep(root);
  return {fs::absolute(root), std::move(warn)};
}

std::optional<StoreEntry> find(const Store& store, const StoreKey& key) {
  const auto place = place_of(store, key);
  for (int attempt = 0; attempt < 10; ++attempt) {
    const Folder folder(place);
    if (!folder) return std::nullopt;
    try {
      return read_entry(place, key);
    } catch (const std::exception& wrong) {
      if (!folder.is_at(place)) continue;  // replaced while it was read
      set_aside(store, place, wrong.what());
      return std::nullopt;
    }
  }
  return std::nullopt;
}

void save(const Store& store, const StoreKey& key, const StoreEntry& entry) {
  const auto place = place_of(store, key);
  std::error_code error;
  fs::create_directories(place.parent_path(), error);
  const Draft draft(place.parent_path());
  const auto image = draft.path / "image.exr";
  write_layers(image, {entry.layer});
  const auto meta = description(key, entry, image);
  // A command may name files in any encoding.
  write_whole(draft.path / "meta.json",
              meta.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  flush(*draft.lock);
  put_in_place(draft, place);
  flush(Folder(place.parent_path()));
}

}  // namespace litmus
