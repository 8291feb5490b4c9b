// random.h: random numbers that depend on a stream and an index alone, so that every sample of an
// experiment can be drawn again by itself, in any order and on any thread.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "tracer/value.h"

namespace litmus {

/// The numbers of one sample: the finaliser of splitmix64 (Steele, Lea and Flood 2014) over a
/// counter.
class Draw {
 public:
  Draw(std::uint64_t stream, std::uint64_t index)
      : state_(mixed(stream * 0x9e3779b97f4a7c15u) ^ mixed(index + 0x632be59bd9b4e019u)) {}

  std::uint64_t bits() { return mixed(state_ += 0x9e3779b97f4a7c15u); }
  /// 0 to count - 1.
  int below(int count) { return int((bits() >> 32) * std::uint64_t(count) >> 32); }
  /// Strictly between 0 and 1.
  double uniform() { return (double(bits() >> 12) + 0.5) * 0x1p-52; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Every decade between the positive numbers low and high is as likely as every other.
  double decades(double low, double high) {
    return std::exp(uniform(std::log(low), std::log(high)));
  }
  /// Evenly over the unit sphere.
  Vec<double> direction() {
    const double z = uniform(-1, 1), angle = uniform(0, 2 * std::numbers::pi);
    const double r = std::sqrt((1 - z) * (1 + z));
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  /// Of unit length, at a right angle to the unit vector `n`.
  Vec<double> across(const Vec<double>& n) {
    const Vec<double> other = direction();
    return normalize(other - dot(other, n) * n);
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace litmus
