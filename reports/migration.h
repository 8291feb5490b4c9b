// migration.h: the old version of a renderer beside the new one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/study.h"

namespace litmus {

/// One light of a scene by two versions of a renderer.
struct MigrationLayer {
  std::string light, light_type;
  Picture old_picture, new_picture;  ///< empty where only the baseline's figures are known
  double old_max = 0, old_mean = 0;  ///< |ours - old| over the whole picture
  double new_max = 0, new_mean = 0;  ///< |ours - new|
  double apart = 0;                  ///< the largest |old - new|; 0 without pictures
  double allowed = 0;                ///< inside, on the largest difference
  std::string old_verdict, new_verdict;
};

struct Migration {
  std::string scene, reference, old_version, new_version;
  bool pictures = true;  ///< false: the old version is the baseline's, of which no picture is kept
  std::vector<MigrationLayer> layers;
};

/// What a renderer of another version does to the scenes of a study: each live picture whose
/// version is not that of the stored images in `images`, beside those; else each row whose version
/// is not the baseline's (nullptr: there is none), beside that. Stored images that are damaged or
/// belong to another version of the scene are left out. `scenes` are those of the study, in its
/// order.
std::vector<Migration> migrations(const Study& study, std::span<const Scene> scenes,
                                  const Study* baseline, const std::filesystem::path& images);

/// migration.html, a page by itself (html_shell.h).
std::string migration_html(const std::vector<Migration>& migrations);

/// Writes it beside the report, whole or not at all; without migrations, removes one that an
/// earlier run left there.
void write_migration(const std::vector<Migration>& migrations, const std::filesystem::path& folder);

}  // namespace litmus
