// expect.cpp: the table of closed forms.
#include "scene/expect.h"

#include <algorithm>
#include <array>

namespace litmus {
namespace {

constexpr std::array kNames{
    OracleName{
        Oracle::Ambient, "ambient",
        "Every pixel of the ambient layer is one material's ka times Ia, or the background."},
    OracleName{Oracle::Floor, "floor",
               "Every pixel that sees a plane has the value that distance and angle give it, where "
               "no caster's cone or slab holds the way to the light."},
    OracleName{Oracle::Spheres, "spheres",
               "Every pixel that sees a sphere: in the frame of its ray the normal is (u, v, "
               "sqrt(1 - u^2 - v^2))."},
    OracleName{Oracle::Boxes, "boxes",
               "Every pixel that sees a box: its face is the last of three pairs of planes that "
               "the ray comes between."},
    OracleName{Oracle::Shell, "shell",
               "Inside a sphere with the light at its centre all pixels are one constant."},
    OracleName{Oracle::Dark, "dark", "No light reaches anything in view: every pixel of it is 0."},
    OracleName{Oracle::ShadowCurves, "shadow-curves",
               "The floor is dark exactly inside the conics of spheres and the polygons of boxes "
               "and triangles."},
    OracleName{Oracle::ConeCurve, "cone-curve",
               "The floor is dark outside the conic in which a spot's cone meets it."},
    OracleName{Oracle::ShadowArea, "shadow-area",
               "The area of the shadow of spheres under the sun is pi r^2 / L.z each."},
    OracleName{Oracle::Highlight, "highlight-peak",
               "The highlight on the floor peaks where the mirror image of the light is."},
    OracleName{Oracle::RectangleLimit, "rectangle-limit",
               "A fine grid of samples comes near to the exact integral over the rectangle."},
};

}  // namespace

std::span<const OracleName> oracle_names() { return kNames; }

std::string_view name_of(Oracle oracle) { return kNames[std::size_t(oracle)].name; }

}  // namespace litmus
