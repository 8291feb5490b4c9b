// shadows.cpp: surfaces that shadow themselves and occluders that are missed, counted at the same
// settings, because a larger offset buys fewer of one with more of the other.
#include <fmt/format.h>

#include <array>
#include <numeric>

#include "stress/naive.h"
#include "stress/random.h"
#include "stress/sweep.h"
#include "stress/ulp.h"
#include "tracer/closest.h"
#include "tracer/visibility.h"

namespace litmus {
namespace {

/// Heights of an occluder above the surface, in units of u * max(|p|, |o|): half the last place of
/// the largest coordinate of the point and the eye.
constexpr std::array kGaps{1,   2,    4,    8,    16,   32,    64,    128,  256,
                           512, 1024, 2048, 4096, 8192, 16384, 32768, 65536};
constexpr std::size_t kStretch = 3, kJudged = 5;  // all gaps from 8 and from 32
constexpr int kRaysPerScene = 64;

/// Where the domain ends for a scalar.
struct Domain {
  double offset;         ///< how far the scene may be from the origin, scene units
  double grazing;        ///< smallest n.l
  double fixed_epsilon;  ///< the control's, scene units
  std::string_view text;
};
template <Real R>
constexpr Domain kDomain =
    std::is_same_v<R, float> ? Domain{1e3, 1e-4, 1e-4, "offset to 1e3, n.l >= 1e-4"}
                             : Domain{1e9, 1e-7, 1e-3, "offset to 1e9, n.l >= 1e-7"};

struct ShadowTally {
  std::uint64_t lit = 0, self = 0, self_without_offset = 0, self_fixed_epsilon = 0;
  std::uint64_t walls = 0, wall = 0, wall_to_the_end = 0;
  std::array<std::uint64_t, kGaps.size()> films{}, missed{}, missed_1500{};

  void add(const ShadowTally& o) {
    lit += o.lit, self += o.self;
    self_without_offset += o.self_without_offset, self_fixed_epsilon += o.self_fixed_epsilon;
    walls += o.walls, wall += o.wall, wall_to_the_end += o.wall_to_the_end;
    for (std::size_t i = 0; i < kGaps.size(); ++i) {
      films[i] += o.films[i], missed[i] += o.missed[i];
      missed_1500[i] += o.missed_1500[i];
    }
  }
};

/// One convex body somewhere, an eye outside of it, and where to aim.
struct Setup {
  Scene scene;
  Point center{0};
  double size = 1;
  bool solid_mesh = false;
};

/// A tetrahedron of flat triangles, in one piece.
Mesh tetrahedron(const Point& center, double size, Draw& draw) {
  Mesh mesh;
  const Vec<double> a = draw.direction(), b = draw.across(a), c = cross(a, b);
  for (const Vec<double>& v : {a, -0.33 * a + 0.94 * b, -0.33 * a - 0.47 * b + 0.82 * c,
                               -0.33 * a - 0.47 * b - 0.82 * c}) {
    mesh.vertices.push_back(center + size * Point(v.x, v.y, v.z));
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return mesh;
}

Setup setup(Draw& draw, double largest_offset) {
  Setup result;
  const auto vector = [&](double length) {
    const Vec<double> v = length * draw.direction();
    return Vector(v.x, v.y, v.z);
  };
  if (draw.below(8) > 0) result.center = vector(draw.decades(1, largest_offset));
  result.size = draw.decades(1e-2, 1e2);
  Scene& scene = result.scene;
  scene.materials.emplace_back();
  Object object;
  switch (draw.below(6)) {
    case 0:
      object.shape = Sphere{result.center, result.size};
      break;
    case 1:
      object.shape = Plane{result.center, vector(1)};
      break;
    case 2:
      object.shape = Box{result.center - result.size, result.center + result.size};
      break;
    case 3:
      object.shape =
          Triangle{result.center + vector(result.size), result.center + vector(result.size),
                   result.center + vector(result.size)};
      break;
    case 4: {  // two flat neighbours, the centre on their common edge
      const Vector u = vector(result.size), v = vector(result.size);
      object.shape = Mesh{{result.center - u - v, result.center + u - v, result.center + u + v,
                           result.center - u + v},
                          {},
                          {{0, 1, 2}, {0, 2, 3}}};
      break;
    }
    default:
      result.solid_mesh = true;
      object.shape = tetrahedron(result.center, result.size, draw);
  }
  scene.objects.push_back(object);
  scene.camera.eye = result.center + vector(result.size * draw.decades(2, 1e4));
  scene.camera.target = result.center;
  return result;
}

/// The same body, grown by `gap`: what hovers above its surface everywhere. Flat bodies get a plane
/// above the face that was hit.
template <Real R>
Plan<R> with_film(Plan<R> plan, const Hit<R>& hit, R gap) {
  if (hit.kind == Kind::Sphere) {
    SphereSurface<R> shell = plan.spheres[std::size_t(hit.index)].shape;
    shell.radius = shell.radius + gap;
    plan.spheres.push_back({shell, 1});
    return plan;
  }
  Vec<R> on = hit.point;
  if (hit.kind == Kind::Plane) on = plan.planes[std::size_t(hit.index)].shape.point;
  if (hit.kind == Kind::Triangle) on = plan.triangles[std::size_t(hit.index)][0];
  plan.planes.push_back({{on + gap * hit.geometric, hit.geometric}, 1});
  return plan;
}

/// Whether the body itself is met at a parameter in (from, limit), as naive code would ask.
template <Real R>
bool meets(const Plan<R>& plan, const Ray<R>& ray, R from) {
  const auto inside = [&](R t) { return t > from && t < ray.limit; };
  const auto chord = [&](const Chord<R>& c) {
    return c.enter <= c.leave && (inside(c.enter) || inside(c.leave));
  };
  for (const auto& part : plan.spheres)
    if (chord(intersect(part.shape, ray))) return true;
  for (const auto& part : plan.boxes)
    if (chord(intersect(part.shape, ray))) return true;
  for (const auto& part : plan.planes)
    if (inside(intersect(part.shape, ray))) return true;
  const ShearedRay<R> sheared(ray.direction);
  for (const auto& triangle : plan.triangles)
    if (inside(intersect(triangle, ray, sheared).t)) return true;
  return false;
}

/// A lamp in the half space above the hit, n.l evenly over the decades down to `grazing`.
template <Real R>
Lamp<R> lamp_above(Draw& draw, const Hit<R>& hit, double size, double grazing) {
  const Vec<double> n = normalize(
      Vec<double>{double(hit.geometric.x), double(hit.geometric.y), double(hit.geometric.z)});
  const double cosine = draw.decades(grazing, 1);
  const Vec<double> toward = cosine * n + std::sqrt(1 - cosine * cosine) * draw.across(n);
  Lamp<R> lamp;
  lamp.directional = draw.below(4) == 0;
  lamp.toward = normalize(Vec<R>{R(toward.x), R(toward.y), R(toward.z)});
  lamp.origin = hit.point + R(size * draw.decades(1, 1e4)) * lamp.toward;
  return lamp;
}

/// Occluders at every height above the surface, and the controls that miss them.
template <Real R>
void try_films(const Plan<R>& plan, const Hit<R>& hit, const Incident<R>& light, R eye_size,
               int which, ShadowTally& tally) {
  const R size = std::max(max_abs(hit.point), eye_size);
  const R gap = R(kGaps[std::size_t(which)]) * kUnit<R> * size;
  // The lamp must be well beyond the film.
  const R cosine = dot(hit.geometric, light.direction);
  if (!(gap / cosine < light.distance / 4)) return;
  const Plan<R> covered = with_film(plan, hit, gap);
  ++tally.films[std::size_t(which)];
  tally.missed[std::size_t(which)] += !occluded(covered, hit, light);
  const Ray<R> plain{hit.point, light.direction, light.distance};
  tally.missed_1500[std::size_t(which)] +=
      !meets(covered, plain, 1500 * std::numeric_limits<R>::epsilon() * (1 + size));
}

/// A wall through the lamp must not hide it.
template <Real R>
void try_wall(Draw& draw, const Plan<R>& plan, const Hit<R>& hit, const Lamp<R>& lamp,
              const Incident<R>& light, ShadowTally& tally) {
  if (lamp.directional) return;
  const Vec<double> d{double(light.direction.x), double(light.direction.y),
                      double(light.direction.z)};
  const double slope = draw.decades(1e-3, 1);
  const Vec<double> n =
      slope * normalize(d) + std::sqrt(1 - slope * slope) * draw.across(normalize(d));
  Plan<R> walled = plan;
  walled.planes.push_back({{lamp.origin, normalize(Vec<R>{R(n.x), R(n.y), R(n.z)})}, 1});
  ++tally.walls;
  tally.wall += occluded(walled, hit, light);
  const R t = intersect(walled.planes.back().shape, Ray<R>{hit.point, light.direction});
  tally.wall_to_the_end += t > 0 && t < light.distance;
}

template <Real R>
void try_ray(Draw& draw, const Plan<R>& plan, const Setup& setup, ShadowTally& tally) {
  // Look at the body, find a lamp that lights the point.
  const Vec<double> aside = setup.size * draw.uniform(0, 1) * draw.direction();
  const Vec<R> aim = Vec<R>(setup.center + Vector(aside.x, aside.y, aside.z));
  const Vec<R> eye(setup.scene.camera.eye);
  const Ray<R> ray{eye, aim - eye};
  const Hit<R> hit = closest_hit(plan, ray);
  if (hit.kind == Kind::None) return;
  // On the very edge of a silhouette a face that looks away is met as well; its normal, turned to
  // the eye, points inwards.
  if (setup.solid_mesh && dot(hit.geometric, hit.point - Vec<R>(setup.center)) < 0) return;
  const Lamp<R> lamp = lamp_above(draw, hit, setup.size, 1.1 * kDomain<R>.grazing);
  const Incident<R> light = incident(lamp, hit.point);
  if (!(dot(hit.geometric, light.direction) >= R(kDomain<R>.grazing))) return;

  // A convex body does not shade a point that faces the lamp.
  ++tally.lit;
  tally.self += occluded(plan, hit, light);
  const Ray<R> naive_ray{ray.origin + hit.t * ray.direction, light.direction, light.distance};
  tally.self_without_offset += meets(plan, naive_ray, R(0));
  tally.self_fixed_epsilon += meets(plan, naive_ray, R(kDomain<R>.fixed_epsilon));

  // But a film above it does, and the lamp's own wall does not.
  try_films(plan, hit, light, max_abs(eye), draw.below(int(kGaps.size())), tally);
  if (draw.below(4) == 0) try_wall(draw, plan, hit, lamp, light, tally);
}

/// The share of occluders missed at each height.
StressCurve missed_curve(const ShadowTally& tally) {
  StressCurve curve{"% of occluders missed",
                    false,
                    "occluder above the surface, u max|p|, log2",
                    0,
                    double(kGaps.size()),
                    {},
                    {}};
  for (std::size_t i = 0; i < kGaps.size(); ++i) {
    const double share = 100.0 / double(std::max<std::uint64_t>(1, tally.films[i]));
    curve.robust.push_back(share * double(tally.missed[i]));
    curve.naive.push_back(share * double(tally.missed_1500[i]));
  }
  return curve;
}

template <Real R>
std::vector<StressRow> rows(std::uint64_t rays) {
  const ShadowTally tally =
      sweep(rays / kRaysPerScene, ShadowTally{}, [](std::uint64_t i, ShadowTally& tally) {
        Draw draw(100 + sizeof(R), i);
        const Setup made = setup(draw, kDomain<R>.offset);
        Plan<R> plan = lower<R>(made.scene);
        plan.camera_visible.push_back(false);  // films and walls
        for (int ray = 0; ray < kRaysPerScene; ++ray) try_ray(draw, plan, made, tally);
      });
  const std::string scalar(kScalarName<R>), domain(kDomain<R>.text);
  const std::string bodies = "spheres, planes, boxes, triangles, meshes 1e-2 to 1e2 large, ";
  std::vector<StressRow> result;
  const bool single = std::is_same_v<R, float>;
  result.push_back({"self-shadow-" + scalar, "rays", "a lit point hidden by its own surface",
                    scalar, bodies + domain, "false shadows", tally.lit, double(tally.self), 0,
                    single ? "fixed epsilon 1e-4" : "no offset",
                    double(single ? tally.self_fixed_epsilon : tally.self_without_offset)});
  const auto from = [](const auto& counts, std::size_t first) {
    return std::accumulate(counts.begin() + long(first), counts.end(), std::uint64_t(0));
  };
  const auto missed = [&](std::size_t first, bool judged) {
    return StressRow{fmt::format("missed-{}u-{}", kGaps[first], scalar),
                     "rays",
                     fmt::format("an occluder {} u max|p| or more above the surface", kGaps[first]),
                     scalar,
                     domain,
                     "missed occluders",
                     from(tally.films, first),
                     double(from(tally.missed, first)),
                     0,
                     "offset of 1500 units in the last place",
                     double(from(tally.missed_1500, first)),
                     judged};
  };
  result.push_back(missed(kJudged, true));
  result.back().curve = missed_curve(tally);
  result.push_back(missed(kStretch, false));
  result.push_back({"wall-" + scalar, "rays", "a lamp on a wall, hidden by that wall", scalar,
                    domain + ", wall 1e-3 to 1 from edge-on", "false shadows", tally.walls,
                    double(tally.wall), 0, "shadow ray up to the lamp",
                    double(tally.wall_to_the_end)});
  return result;
}

}  // namespace

std::vector<StressRow> stress_shadows(const StressOptions& options) {
  std::vector<StressRow> result = rows<float>(options.rays);
  for (StressRow& row : rows<double>(options.rays)) result.push_back(std::move(row));
  return result;
}

}  // namespace litmus
