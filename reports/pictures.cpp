// pictures.cpp: the small pictures of a report, as text that a page can hold.
#include "reports/pictures.h"

#include <algorithm>
#include <cmath>

#include "compare/image_io.h"
#include "reports/packing.h"

namespace litmus {
namespace {

// The mean of the pixels of `picture` that fall into one pixel of a smaller one.
glm::dvec3 box_mean(const Picture& picture, double left, double top, double right, double bottom) {
  glm::dvec3 total(0);
  double weight = 0;
  for (int y = int(top); y < std::min(int(std::ceil(bottom)), picture.height); ++y)
    for (int x = int(left); x < std::min(int(std::ceil(right)), picture.width); ++x) {
      const double w = (std::min(right, x + 1.0) - std::max(left, double(x))) *
                       (std::min(bottom, y + 1.0) - std::max(top, double(y)));
      total += w * picture.at(x, y);
      weight += w;
    }
  return total / weight;
}

}  // namespace

std::string data_uri(std::string_view png) { return "data:image/png;base64," + base64(png); }

std::string picture_uri(const Picture& picture) { return data_uri(encode_png(picture)); }

std::string thumbnail_uri(const Picture& picture, int side) {
  const double factor = std::max(1.0, double(std::max(picture.width, picture.height)) / side);
  Picture small(std::max(1, int(std::lround(picture.width / factor))),
                std::max(1, int(std::lround(picture.height / factor))));
  const double across = double(picture.width) / small.width;
  const double down = double(picture.height) / small.height;
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      small.at(x, y) = box_mean(picture, x * across, y * down, (x + 1) * across, (y + 1) * down);
  return picture_uri(small);
}

}  // namespace litmus
