#include <limits>
#include <numbers>

#include <fairlight/validation/checks/domains.h>

namespace fairlight {
namespace {

constexpr double turn = 2 * std::numbers::pi, unlimited = std::numeric_limits<double>::infinity();

using Rows = std::vector<ParameterDomain>;

void append(Rows& rows, const Rows& more) { rows.insert(rows.end(), more.begin(), more.end()); }

// The rows that all lights have: their place and their orientation.
void add_light(Rows& rows, const std::string& light, double smallest, const std::string& sizes,
               const std::string& surfaces) {
  append(rows, {{light, "distance", "m", 1e-10, 1e10, "sides, radii and coordinates have these limits too"},
                {light, "size / distance", "1", smallest, unlimited, sizes},
                {light, "place / distance", "1", -unlimited, unlimited,
                 "floats lose the digits by which a place exceeds the distance"},
                {light, "cosine at the surface", "1", -1, 1, surfaces},
                {light, "azimuth at the surface", "rad", 0, turn, ""},
                {light, "height of the axis", "1", -1, 1, ""},
                {light, "azimuth of the axis", "rad", 0, turn, ""}});
}

void add_rectangle(Rows& rows, const std::string& light, const std::string& sizes) {
  add_light(rows, light, 0, sizes, "a surface that faces away is lit by little or nothing");
  append(rows, {{light, "shorter / longer side", "1", 1e-20, 1, "the sides have the limits of the distance"},
                {light, "which side is longer", "1", 0, 1, ""},
                {light, "cosine at the light", "1", -1, 1, ""},
                {light, "azimuth at the light", "rad", 0, turn, ""},
                {light, "turn about the axis", "rad", 0, turn, ""}});
}

void add_sphere(Rows& rows, const std::string& light) {
  add_light(rows, light, 1e-16, "unit tests see it from its centre", "");
  rows.push_back({light, "cosine / sine of the cone", "1", -1, 1,
                  "above 1 it is the cosine at the surface; below, "
                  "little or nothing of the sphere is in sight"});
}

}  // namespace

std::vector<ParameterDomain> domains_of_lights() {
  Rows rows;
  add_rectangle(rows, "RectangleByArea",
                "smaller ones are points; from nearer, draws by area vary too much to be tested");
  add_rectangle(rows, "RectangleBySolidAngle", "smaller ones are points; larger ones are planes without end");
  rows.push_back({"RectangleBySolidAngle", "foot along a side", "1", 0, 1,
                  "a foot at the rim, or beside it, has the rows of the cosine at the light"});
  for (const char* light : {"TriangleByArea", "TriangleBySolidAngle"}) {
    add_rectangle(rows, light, "smaller ones are points; larger ones are claimed as rectangles");
    rows.push_back({light, "shear", "1", -unlimited, unlimited, "more of it makes the sides longer"});
  }
  for (const char* light : {"SphereByArea", "SphereByCone", "SphereByVisibleHemisphere"}) add_sphere(rows, light);
  return rows;
}

}  // namespace fairlight
