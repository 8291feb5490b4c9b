// formulas.cpp: the formulas of slides 5-20 over their declared domains, against the slides' own
// forms in quad precision.
#include <fmt/format.h>

#include <numbers>

#include "stress/naive.h"
#include "stress/random.h"
#include "stress/sweep.h"
#include "stress/ulp.h"
#include "tracer/lights.h"
#include "tracer/shade.h"
#include "tracer/sum.h"

namespace litmus {
namespace {

constexpr double kPi = std::numbers::pi;

template <Real R>
Vec<R> rounded(const Vec<double>& v) {
  return {R(v.x), R(v.y), R(v.z)};
}
template <Real R>
Vec<Quad> exact(const Vec<R>& v) {
  return {Quad(v.x), Quad(v.y), Quad(v.z)};
}

/// The largest length or range of the declared domain, and its smallest by the reciprocal.
template <Real R>
constexpr double kFarthest = std::is_same_v<R, float> ? 1e36 : 1e307;
/// The smallest angle, and distance to a limit relative to it.
template <Real R>
constexpr double kSmallest = std::is_same_v<R, float> ? 1e-7 : 1e-12;

/// An experiment on one formula: what it is, where, and one sample of it.
struct Experiment {
  std::string id, what, domain, metric, control, x_label;
  double bound, low, high;  ///< low and high of the curve's coordinate
};

template <Real R>
StressRow row_of(const Experiment& e, std::uint64_t samples, const UlpTally& tally) {
  return {
      fmt::format("{}-{}", e.id, kScalarName<R>),
      "formulas",
      e.what,
      std::string(kScalarName<R>),
      e.domain,
      e.metric,
      samples,
      tally.robust,
      e.bound,
      e.control,
      tally.naive,
      true,
      StressCurve{e.metric, true, e.x_label, e.low, e.high, tally.robust_bins, tally.naive_bins}};
}

/// Draws `samples` samples of `e`; one(draw, tally) notes the errors of one.
template <Real R, class One>
StressRow experiment(const Experiment& e, std::uint64_t samples, const One& one) {
  const std::uint64_t stream = std::hash<std::string>{}(e.id) + sizeof(R);
  const UlpTally tally =
      sweep(samples, UlpTally{e.low, e.high}, [&](std::uint64_t i, UlpTally& tally) {
        Draw draw(stream, i);
        one(draw, tally);
      });
  return row_of<R>(e, samples, tally);
}

template <Real R>
StressRow angle(std::uint64_t samples) {
  const double smallest = kSmallest<R>;
  const Experiment e{
      "alpha",
      "angle to a spot's axis (slide 16)",
      fmt::format("{:.0e} rad to pi - {:.0e} rad; vectors 1e-6 to 1e6 long", smallest, smallest),
      "ulp",
      "arccosine of the dot product",
      "log10 of the angle in radians",
      5,
      std::log10(smallest),
      std::log10(kPi)};
  return experiment<R>(e, samples, [&](Draw& draw, UlpTally& tally) {
    const double small = draw.decades(smallest, kPi / 2);
    const double wanted = draw.below(3) == 0 ? kPi - small : small;
    const Vec<double> axis = draw.direction(), side = draw.across(axis);
    const Vec<R> a = rounded<R>(draw.decades(1e-6, 1e6) * axis);
    const Vec<R> b =
        rounded<R>(draw.decades(1e-6, 1e6) * (std::cos(wanted) * axis + std::sin(wanted) * side));
    const Vec<Quad> qa = exact(a), qb = exact(b), c = cross(qa, qb);
    const Quad truth = atan2(sqrt(dot(c, c)), dot(qa, qb));
    tally.note(std::log10(double(truth)), ulps(angle_between(a, b), truth),
               ulps(naive::angle_between(a, b), truth));
  });
}

template <Real R>
StressRow decay(std::uint64_t samples) {
  const double smallest = kSmallest<R>;
  const Experiment e{"decay",
                     "spot decay (slide 16)",
                     fmt::format("cutoff 1e-3 to pi, alpha from 1e-6 cutoff to {:.0e} cutoff "
                                 "before it, exponent 1e-6 to 1e6",
                                 smallest),
                     "ulp",
                     "1 - pow(alpha / cutoff, exponent)",
                     "log10 of 1 - alpha / cutoff",
                     4,
                     std::log10(smallest),
                     0};
  return experiment<R>(e, samples, [&](Draw& draw, UlpTally& tally) {
    const R cutoff = R(draw.decades(1e-3, kPi)), exponent = R(draw.decades(1e-6, 1e6));
    const bool near_cutoff = draw.below(2) == 0;
    const double ratio = near_cutoff ? 1 - draw.decades(smallest, 1) : draw.decades(1e-6, 1);
    const R alpha = R(ratio * double(cutoff));
    if (!(alpha > 0 && alpha < cutoff)) return;
    const Quad quotient = Quad(alpha) / Quad(cutoff);
    const Quad truth = -expm1(Quad(exponent) * log(quotient));
    tally.note(std::log10(double(1 - quotient)), ulps(spot_decay(alpha, cutoff, exponent), truth),
               ulps(naive::spot_decay(alpha, cutoff, exponent), truth));
  });
}

/// Range, distance and a coefficient anywhere in the scalar's range. One in 8 lies where distance
/// and coefficient are largest: their product overflows there, and even a short experiment shows
/// what that does to the usual form.
template <Real R>
struct Falloff {
  R range, distance, coefficient;

  explicit Falloff(Draw& draw) {
    const bool at_the_end = draw.below(8) == 0;
    range = R(draw.decades(1 / kFarthest<R>, kFarthest<R>));
    distance = R(draw.decades(at_the_end ? kFarthest<R> / 10 : 1 / kFarthest<R>, kFarthest<R>));
    coefficient = R(draw.decades(at_the_end ? 1e2 : 1e-3, 1e3));
    if (!at_the_end && draw.below(16) == 0) coefficient = 0;
  }
  bool in_domain() const { return std::isfinite(distance / range); }
  double x() const { return std::log10(double(distance)) - std::log10(double(range)); }
};

template <Real R>
Experiment falloff(const char* id, const char* what, const char* control, double bound) {
  const double decades = std::log10(kFarthest<R>);
  return {id,
          what,
          fmt::format("R and d 1e-{0:.0f} to 1e{0:.0f}, d / R finite, coefficient 0 or 1e-3 to 1e3",
                      decades),
          "ulp",
          control,
          "log10 of x = d / R",
          bound,
          -2 * decades,
          decades};
}

template <Real R>
StressRow linear(std::uint64_t samples) {
  const auto e = falloff<R>("l", "linear attenuation (slide 11)", "R / (R + L d)", 4);
  return experiment<R>(e, samples, [](Draw& draw, UlpTally& tally) {
    const Falloff<R> f(draw);
    if (!f.in_domain()) return;
    const Quad r(f.range), truth = r / (r + Quad(f.coefficient) * Quad(f.distance));
    tally.note(f.x(), ulps(linear_attenuation(R(f.distance / f.range), f.coefficient), truth),
               ulps(naive::linear_attenuation(f.range, f.distance, f.coefficient), truth));
  });
}

template <Real R>
StressRow quadratic(std::uint64_t samples) {
  const auto e = falloff<R>("q", "quadratic attenuation (slide 11)", "R^2 / (R^2 + Q d^2)", 5);
  return experiment<R>(e, samples, [](Draw& draw, UlpTally& tally) {
    const Falloff<R> f(draw);
    if (!f.in_domain()) return;
    const Quad r(f.range), d(f.distance), truth = r * r / (r * r + Quad(f.coefficient) * d * d);
    tally.note(f.x(), ulps(quadratic_attenuation(R(f.distance / f.range), f.coefficient), truth),
               ulps(naive::quadratic_attenuation(f.range, f.distance, f.coefficient), truth));
  });
}

/// One highlight and its truth, (cos angle)^ns of the vectors as they are.
template <Real R>
struct Highlight {
  R shininess;
  Vec<R> h, n;
  Quad truth;

  /// Highlights down to exp(-faintest), half of them in the outer half, where errors are largest,
  /// and half of all with a whole exponent.
  Highlight(Draw& draw, double faintest) : shininess(R(draw.decades(1, 1e6))) {
    if (draw.below(2) == 0) shininess = std::round(shininess);
    const double widest = std::acos(std::exp(-faintest / double(shininess)));
    const double apart = draw.below(2)   ? draw.uniform(widest / 2, widest)
                         : draw.below(2) ? draw.uniform(0, widest)
                                         : draw.decades(1e-9, widest);
    const Vec<double> axis = draw.direction(), side = draw.across(axis);
    n = normalize(rounded<R>(axis));
    h = normalize(rounded<R>(std::cos(apart) * axis + std::sin(apart) * side));
    const Vec<Quad> qn = exact(n), qh = exact(h);
    const Quad cosine = dot(qh, qn) / sqrt(dot(qn, qn) * dot(qh, qh));
    truth = cosine > 0 ? Quad(exp(Quad(shininess) * log(cosine))) : Quad(0);
  }
};

template <Real R>
StressRow specular(std::uint64_t samples) {
  const Experiment e{"specular",
                     "highlight (h.n)^ns (slide 5)",
                     "ns 1 to 1e6, h and n unit to rounding, highlights over 1/7",
                     "ulp",
                     "pow(h.n, ns)",
                     "log10 of ns",
                     12,
                     0,
                     6};
  return experiment<R>(e, samples, [](Draw& draw, UlpTally& tally) {
    const Highlight<R> s(draw, std::log(7.0));
    tally.note(std::log10(double(s.shininess)),
               ulps(power_of_cosine(s.h, s.n, s.shininess), s.truth),
               ulps(naive::specular_power(s.h, s.n, s.shininess), s.truth));
  });
}

template <Real R>
StressRow faint_specular(std::uint64_t samples) {
  const Experiment e{"highlight",
                     "highlight (h.n)^ns (slide 5), absolute",
                     "ns 1 to 1e6, h and n unit to rounding, highlights down to 1e-30",
                     "ulp of 1",
                     "pow(h.n, ns)",
                     "log10 of ns",
                     12,
                     0,
                     6};
  return experiment<R>(e, samples, [](Draw& draw, UlpTally& tally) {
    const Highlight<R> s(draw, 70);
    const auto error = [&](R seen) {
      if (!std::isfinite(seen)) return std::numeric_limits<double>::infinity();
      return double(fabs(Quad(seen) - s.truth)) / double(std::numeric_limits<R>::epsilon());
    };
    tally.note(std::log10(double(s.shininess)), error(power_of_cosine(s.h, s.n, s.shininess)),
               error(naive::specular_power(s.h, s.n, s.shininess)));
  });
}

/// How far three axes are from being orthonormal: the largest deviation of a length from 1 or of a
/// product of two from 0.
template <Real R>
double skew(const Vec<R>& n, const Vec<R>& right, const Vec<R>& up) {
  const Vec<Quad> axes[] = {exact(n), exact(right), exact(up)};
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const Quad product = dot(axes[i], axes[j]);
      const double off = double(i == j ? fabs(sqrt(product) - 1) : fabs(product));
      if (!(off <= worst)) worst = off;
      if (std::isnan(off)) return std::numeric_limits<double>::infinity();
    }
  }
  return worst;
}

template <Real R>
StressRow frame(std::uint64_t samples) {
  const Experiment e{"frame",
                     "axes of an area light (slide 20)",
                     "normals everywhere, half of them 1e-30 to 1 off the pole, 1 in 64 on it",
                     "deviation from orthonormal",
                     "up x n and n x right, not normalised",
                     "log10 of the distance from the pole",
                     std::is_same_v<R, float> ? 2.5e-7 : 5e-16,
                     -30,
                     0};
  return experiment<R>(e, samples, [](Draw& draw, UlpTally& tally) {
    Vec<double> n = draw.direction();
    if (draw.below(2) == 0) {
      const double off = draw.below(32) == 0 ? 0 : draw.decades(1e-30, 1);
      const double angle = draw.uniform(0, 2 * kPi);
      n = {off * std::cos(angle), off * std::sin(angle), draw.below(2) ? 1.0 : -1.0};
    }
    AreaLight light;
    light.normal = Vector(n.x, n.y, n.z);
    const AreaFrame<R> f = area_frame<R>(light);
    Vec<R> right, up;
    naive::area_axes(f.normal, right, up);
    tally.note(std::log10(std::hypot(n.x, n.y)), skew(f.normal, f.right, f.up),
               skew(f.normal, right, up));
  });
}

template <Real R>
StressRow light_sum(std::uint64_t samples) {
  const Experiment e{"sum",
                     "sum of the lamps of an area light (slide 19)",
                     "1 to 4096 terms from 1e-6 to 1 each",
                     "ulp",
                     "one addition after the other",
                     "log10 of the number of terms",
                     1,
                     0,
                     std::log10(4096.0)};
  return experiment<R>(e, samples, [](Draw& draw, UlpTally& tally) {
    const int count = int(draw.decades(1, 4097));
    Total<R> total;
    R plain = 0;
    Quad truth = 0;
    for (int i = 0; i < count; ++i) {
      const double u = draw.uniform();
      const R term = R(1e-6 + u * u * u * u);
      total.add(term), plain += term, truth += Quad(term);
    }
    tally.note(std::log10(double(count)), ulps(R(total.value()), truth), ulps(plain, truth));
  });
}

template <Real R>
std::vector<StressRow> all_formulas(std::uint64_t samples) {
  return {angle<R>(samples),     decay<R>(samples),    linear<R>(samples),
          quadratic<R>(samples), specular<R>(samples), faint_specular<R>(samples),
          frame<R>(samples),     light_sum<R>(samples)};
}

}  // namespace

std::vector<StressRow> stress_formulas(const StressOptions& options) {
  std::vector<StressRow> rows = all_formulas<float>(options.samples);
  for (StressRow& row : all_formulas<double>(options.samples)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace litmus
