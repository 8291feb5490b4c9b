// store_test.cpp: what is saved is found exactly; what is damaged or half made is never used.
#include "reference/store.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>

#include <thread>

#include "scene/refusal.h"
#include "tests/reference/sample_scene.h"

namespace litmus {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

StoreKey sample_key() { return {"f00d", 1, "key", "povray", 2, "50ce", "3.7.0", "0.1.0"}; }

StoreEntry sample_entry(double seed = 1) {
  return {{"key", "point", sample_picture(6, 4, seed)}, 1.25, "povray +Ikey.pov"};
}

struct StoreTest : InFolder {
  std::vector<std::string> warnings;
  Store store;
  void SetUp() override {
    InFolder::SetUp();
    store = open();
  }
  Store open() {
    return open_store(folder / "store",
                      [this](const std::string& text) { warnings.push_back(text); });
  }
  fs::path entry_folder(const StoreKey& key) const {
    const auto digits = hash(key);
    return store.root / digits.substr(0, 2) / digits.substr(2);
  }
  /// Names in the folder that holds the entry.
  std::vector<std::string> names_beside(const StoreKey& key) const {
    std::vector<std::string> names;
    for (const auto& it : fs::directory_iterator(entry_folder(key).parent_path()))
      names.push_back(it.path().filename().string());
    return names;
  }
  /// Expects that the damaged entry is not used, is set aside with a warning, and is replaced by
  /// the next.
  void expect_set_aside(const std::string& reason) {
    EXPECT_FALSE(find(store, sample_key()));
    EXPECT_THAT(warnings, ElementsAre(HasSubstr(reason)));
    EXPECT_THAT(names_beside(sample_key()), ElementsAre(testing::StartsWith(".damaged-")));
    EXPECT_FALSE(find(store, sample_key()));  // now simply missing
    EXPECT_EQ(warnings.size(), 1u);
    save(store, sample_key(), sample_entry());
    EXPECT_TRUE(find(store, sample_key()));
  }
};

using Stores = StoreTest;

TEST_F(Stores, FindWhatWasSaved) {
  save(store, sample_key(), sample_entry());
  const auto found = find(store, sample_key());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->layer.light, "key");
  EXPECT_EQ(found->layer.light_type, "point");
  EXPECT_TRUE(same(found->layer.picture, sample_entry().layer.picture));
  EXPECT_EQ(found->seconds, 1.25);
  EXPECT_EQ(found->command, "povray +Ikey.pov");
  EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(Stores, FindNothingInTheBeginning) { EXPECT_FALSE(find(store, sample_key())); }

TEST_F(Stores, TellKeysApartByEveryPart) {
  save(store, sample_key(), sample_entry());
  std::vector<StoreKey> others(8, sample_key());
  others[0].scene = "f00e";
  others[1].layer = 2;
  others[2].light = "kez";
  others[3].reference = "blender";
  others[4].revision = 3;
  others[5].source = "50cf";
  others[6].renderer_version = "3.7.1";
  others[7].program_version = "0.1.1";
  for (const auto& other : others) EXPECT_FALSE(find(store, other)) << hash(other);
}

TEST_F(Stores, ReplaceAnEntryOfTheSameKey) {
  save(store, sample_key(), sample_entry(1));
  save(store, sample_key(), sample_entry(2));
  EXPECT_TRUE(same(find(store, sample_key())->layer.picture, sample_entry(2).layer.picture));
  EXPECT_EQ(names_beside(sample_key()).size(), 1u);
}

TEST_F(Stores, SetAsideAnImageWithAFlippedBit) {
  save(store, sample_key(), sample_entry());
  const auto image = entry_folder(sample_key()) / "image.exr";
  auto bytes = text_of(image);
  bytes[bytes.size() - 3] ^= 1;
  write_text(image, bytes);
  expect_set_aside("checksum");
}

TEST_F(Stores, SetAsideATruncatedImage) {
  save(store, sample_key(), sample_entry());
  fs::resize_file(entry_folder(sample_key()) / "image.exr", 100);
  expect_set_aside("checksum");
}

TEST_F(Stores, SetAsideAnEntryWithoutImage) {
  save(store, sample_key(), sample_entry());
  fs::remove(entry_folder(sample_key()) / "image.exr");
  expect_set_aside("cannot be read");
}

TEST_F(Stores, SetAsideAnUnreadableDescription) {
  save(store, sample_key(), sample_entry());
  write_text(entry_folder(sample_key()) / "meta.json", "{\"schema\": 1, ");
  expect_set_aside("parse error");
}

TEST_F(Stores, SetAsideAnEntryOfAnotherKey) {
  auto other = sample_key();
  other.scene = "beef";
  save(store, other, sample_entry());
  fs::create_directories(entry_folder(sample_key()).parent_path());
  fs::rename(entry_folder(other), entry_folder(sample_key()));
  expect_set_aside("another key");
}

TEST_F(Stores, SweepWhatADeadProcessLeft) {
  save(store, sample_key(), sample_entry());
  const auto left = entry_folder(sample_key()).parent_path() / ".tmp-abcdef";
  fs::create_directory(left);
  write_text(left / "image.exr", "half");
  open();
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(find(store, sample_key()));
}

TEST_F(Stores, LeaveWhatALivingProcessIsWriting) {
  save(store, sample_key(), sample_entry());
  const auto busy = entry_folder(sample_key()).parent_path() / ".tmp-abcdef";
  fs::create_directory(busy);
  const int lock = ::open(busy.c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(lock, LOCK_EX), 0);
  open();
  EXPECT_TRUE(fs::exists(busy));
  ::close(lock);
  open();
  EXPECT_FALSE(fs::exists(busy));
}

TEST_F(Stores, ServeManyThreadsThatReplaceAndReadOneEntry) {
  save(store, sample_key(), sample_entry(1));
  std::atomic<int> found = 0, wrong = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 25; ++i) {
        if (t % 2 == 0) {
          save(store, sample_key(), sample_entry(1 + t));
        } else if (const auto entry = find(store, sample_key())) {
          ++found;
          const auto& picture = entry->layer.picture;
          wrong += !same(picture, sample_entry(1).layer.picture) &&
                   !same(picture, sample_entry(3).layer.picture);
        }
        if (i % 5 == 0) open_store(store.root);  // a sweep takes nothing from the living
      }
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(found, 50);  // the entry is there at every moment
  EXPECT_EQ(wrong, 0);
  EXPECT_THAT(warnings, IsEmpty());
}

TEST_F(Stores, AreRefusedWhereNothingCanBeWritten) {
  write_text(folder / "file", "");
  EXPECT_THROW(open_store(folder / "file" / "store"), Refusal);
}

TEST_F(Stores, LieInTheCacheFolderOfTheUser) {
  ::setenv("HOME", "/home/somebody", 1);
  ::setenv("XDG_CACHE_HOME", "/caches", 1);
  EXPECT_EQ(default_store_directory(), "/caches/litmus");
  ::unsetenv("XDG_CACHE_HOME");
  EXPECT_EQ(default_store_directory(), "/home/somebody/.cache/litmus");
  ::unsetenv("HOME");
  ::setenv("TMPDIR", folder.c_str(), 1);
  EXPECT_EQ(default_store_directory().parent_path(), folder);
  ::unsetenv("TMPDIR");
}

}  // namespace
}  // namespace litmus
