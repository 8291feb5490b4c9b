// quadrature_bound_test.cpp: no quadrature is further off than the bound says.
#include "tracer/quadrature_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tracer/gauss.h"
#include "tracer/region.h"

namespace litmus {
namespace {

using V3 = Vec<double>;

struct Piece {
  LightPatch patch;
  V3 across, up;
};

Piece random_piece(std::mt19937_64& engine) {
  std::uniform_real_distribution<double> random(0, 1);
  const V3 center{2 * random(engine) - 1, 2 * random(engine) - 1, 1 + 2 * random(engine)};
  const double size = 0.4 * random(engine) * random(engine);
  Piece piece{{}, {size, 0, 0.2 * size}, {0, 0.7 * size, 0}};  // at right angles
  LightPatch& patch = piece.patch;
  patch.lamp.origin = center;
  patch.lamp.attenuated = random(engine) < 0.5;
  patch.lamp.range = 2, patch.lamp.linear = 0.5, patch.lamp.quadratic = 1.5;
  const Direction<double> to = direction_of(center);
  patch.distance = to.length, patch.l = to.unit;
  patch.across = direction_of(piece.across).length / to.length;
  patch.up = direction_of(piece.up).length / to.length;
  patch.slant = std::max(std::fabs(dot(normalize(piece.across), to.unit)),
                         std::fabs(dot(normalize(piece.up), to.unit)));
  patch.n = {0, 0, 1};
  // Half of the eyes look along the mirrored light: into the highlight.
  const V3 mirrored{-to.unit.x, -to.unit.y, to.unit.z};
  const V3 aside{0.6 * random(engine), 0.6 * random(engine), 0.1};
  patch.e = normalize(random(engine) < 0.5 ? mirrored : mirrored + aside);
  patch.shininess = std::pow(200, random(engine)), patch.shiny = true;
  return piece;
}

/// D and S, D below the horizon as well.
Terms<double> terms_at(const Piece& piece, double u, double v) {
  const LightPatch& patch = piece.patch;
  Lamp<double> lamp = patch.lamp;
  lamp.origin = lamp.origin + u * piece.across + v * piece.up;
  const Incident<double> light = incident(lamp, V3{});
  return ungated_terms(light.direction, patch.e, patch.n, patch.shininess, light.intensity, true);
}

Terms<double> quadrature(const Piece& piece, int points) {
  const GaussRule rule = gauss_rule(points);
  Terms<double> total;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const Terms<double> terms = terms_at(piece, rule.nodes[i], rule.nodes[j]);
      total.diffuse += rule.weights[i] * rule.weights[j] * terms.diffuse;
      total.specular += rule.weights[i] * rule.weights[j] * terms.specular;
    }
  }
  return total;
}

TEST(QuadratureBound, IsNotExceededOverTheWholePiece) {
  std::mt19937_64 engine(5);
  int useful = 0, pieces = 600;
  for (int i = 0; i < pieces; ++i) {
    const Piece piece = random_piece(engine);
    const Terms<double> exact = quadrature(piece, 24);
    const auto bounds = quadrature_bounds(piece.patch, Region::Whole).error;
    for (int points = 1; points <= kMostPoints; ++points) {
      const Terms<double> got = quadrature(piece, points);
      const Terms<double> bound = bounds[std::size_t(points - 1)];
      EXPECT_LE(std::fabs(got.diffuse - exact.diffuse), bound.diffuse + 1e-14);
      EXPECT_LE(std::fabs(got.specular - exact.specular), bound.specular + 1e-14);
      useful += points == 3 && bound.diffuse < 1e-4 && bound.specular < 1e-2;
    }
  }
  EXPECT_GT(useful, pieces / 3) << "a bound of infinity would hold too";
}

/// The integral over v > u, by Gauss's rule in u and from u to 1 in v, over the piece's area.
Terms<double> over_a_triangle(const Piece& piece) {
  static const GaussRule rule = gauss_rule(24);
  Terms<double> total;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double u = rule.nodes[i], middle = (u + 1) / 2, half = (1 - u) / 2;
    for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
      const Terms<double> terms = terms_at(piece, u, middle + half * rule.nodes[j]);
      total.diffuse += half * rule.weights[i] * rule.weights[j] * terms.diffuse;
      total.specular += half * rule.weights[i] * rule.weights[j] * terms.specular;
    }
  }
  return total;
}

TEST(QuadratureBound, IsNotExceededOverAPartOfThePiece) {
  std::mt19937_64 engine(8);
  Polygon part = Polygon::square();
  part.clip(HalfPlane{0, -1, 1});
  int useful = 0, pieces = 600;
  for (int i = 0; i < pieces; ++i) {
    const Piece piece = random_piece(engine);
    const Terms<double> exact = over_a_triangle(piece);
    const auto [largest, bounds] = quadrature_bounds(piece.patch, Region::Part);
    for (int points = 1; points <= kMostPoints; ++points) {
      Moments moments{points};
      add_polygon(moments, part, 1);
      const auto weights = node_weights(moments);
      const GaussRule rule = gauss_rule(points);
      Terms<double> got;
      for (int k = 0; k < points * points; ++k) {
        const Terms<double> terms = terms_at(piece, rule.nodes[std::size_t(k / points)],
                                             rule.nodes[std::size_t(k % points)]);
        got.diffuse += weights[std::size_t(k)] * terms.diffuse;
        got.specular += weights[std::size_t(k)] * terms.specular;
      }
      // Half of the piece, so at most half of the largest term.
      got.diffuse = std::clamp(got.diffuse, 0.0, largest.diffuse / 2);
      got.specular = std::clamp(got.specular, 0.0, largest.specular / 2);
      const Terms<double> bound = bounds[std::size_t(points - 1)];
      EXPECT_LE(std::fabs(got.diffuse - exact.diffuse), bound.diffuse / 2 + 1e-14);
      EXPECT_LE(std::fabs(got.specular - exact.specular), bound.specular / 2 + 1e-14);
      useful += points == kMostPoints && bound.diffuse < 1e-3 && bound.specular < 1e-1;
    }
  }
  EXPECT_GT(useful, pieces / 4) << "a bound of infinity would hold too";
}

TEST(LargestTerms, AreNotExceededOnThePiece) {
  std::mt19937_64 engine(6);
  for (int i = 0; i < 600; ++i) {
    const Piece piece = random_piece(engine);
    const Terms<double> most = quadrature_bounds(piece.patch, Region::Whole).largest;
    for (double u = -1; u <= 1; u += 0.25) {
      for (double v = -1; v <= 1; v += 0.25) {
        Lamp<double> lamp = piece.patch.lamp;
        lamp.origin = lamp.origin + u * piece.across + v * piece.up;
        const Incident<double> light = incident(lamp, V3{});
        const V3 &l = light.direction, &e = piece.patch.e, &n = piece.patch.n;
        const double power = specular_power(l, e, n, piece.patch.shininess);
        const Terms<double> terms = equation_terms(dot(l, n), power, light.intensity);
        EXPECT_LE(terms.diffuse, most.diffuse + 1e-14);
        EXPECT_LE(terms.specular, most.specular + 1e-14);
      }
    }
  }
}

}  // namespace
}  // namespace litmus
