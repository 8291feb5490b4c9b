// page_data.h: the pictures of a scene as JSON for the page.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "reports/packing.h"
#include "reports/study.h"

namespace litmus {

/// ours - theirs, and -theirs where ours is not finite: either way the page gets theirs back. The
/// pictures have one size.
Picture packed_difference(const Picture& ours, const Picture& theirs);

/// The text as one word for the shell, quoted where it has to be.
std::string shell_word(const std::string& text);

/// The shorter of a scene's name and its file as a word for the shell, quoted where it has to be.
std::string scene_word(const Case& one);

/// How finely the differences to a scene's references are kept.
enum class Detail {
  Full,    ///< to 1/256 of what is allowed inside, 1/32 where no row fails; half floats at most
  Coarse,  ///< besides, to 1/64 of the largest in the picture
};

/// All pictures of a scene as JSON: ours for each layer (the whole as the sum of the others, if it
/// is), for each of its references the difference, what is allowed, the edges, and what the light
/// does (kLit and so on). Closed forms that give pixels are one more reference, with the pixels
/// that they are known at. reports/web/data.js reads it.
std::string pictures_json(const Study& study, const Case& one, Detail detail = Detail::Full);

/// pictures_json for each case in the study's order. Where that is more than `budget` bytes, the
/// failing scenes that are least off become coarse, as many as it takes.
std::vector<std::string> pictures_within(const Study& study, std::size_t budget);

}  // namespace litmus
