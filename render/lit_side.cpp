#include <algorithm>
#include <cmath>

#include <fairlight/render/lit_side.h>

namespace fairlight {
namespace {

bool emits(const Surface& surface) { return (surface.radiance > 0).any(); }

// Whether `holds(distance of the centres [m], radius of the sphere [m], luminaire)` is true for
// every luminaire.
bool for_all_luminaires(const Scene& scene, const Sphere<double>& sphere, const auto& holds) {
  const double radius = sphere.normal.norm() / sphere.curvature;
  const Vec3<double> centre = sphere.anchor - sphere.normal / sphere.curvature;
  return std::ranges::all_of(scene.luminaires(), [&](const Luminaire& light) {
    return holds((light.centre - centre).norm(), radius, light);
  });
}

// A factor above the rounding errors of distances and radii.
constexpr double rounded_up = 1 + 1e-14;

// A spherical luminaire may also enclose the sphere. A rectangle is replaced by its bounding
// sphere.
bool is_outside(double distance, double radius, const Luminaire& light) {
  return distance > rounded_up * (radius + light.radius) ||
         (!light.is_rectangle && light.radius > rounded_up * (radius + distance));
}
bool is_inside(double distance, double radius, const Luminaire& light) {
  return radius > rounded_up * (distance + light.radius);
}

// The largest signed distance of a surface's points from a plane, along its normal [m].
double reach_beyond(const Sphere<double>& plane, const Surface& surface) {
  const double middle = plane.normal.dot(surface.shape.anchor - plane.anchor);
  const Vec3<double>& normal = surface.shape.normal;
  if (!surface.rectangle) return middle + (normal.norm() - plane.normal.dot(normal)) / surface.shape.curvature;
  const auto half = [&](const Vec3<double>& axis) { return std::abs(plane.normal.dot(axis)) / axis.squaredNorm(); };
  return middle + half(surface.rectangle->x) + half(surface.rectangle->y);
}

// Whether no surface reaches beyond the plane, up to the rounding of positions.
bool none_beyond(const Sphere<double>& plane, const Scene& scene) {
  return std::ranges::all_of(scene.surfaces(), [&](const Surface& surface) {
    return reach_beyond(plane, surface) <= 1e-14 * (surface.shape.anchor.norm() + plane.anchor.norm());
  });
}

}  // namespace

LitSide lit_side(const Scene& scene, std::size_t surface) {
  const Surface& obstacle = scene.surfaces()[surface];
  const bool blocks = !obstacle.rectangle && obstacle.material.kind != Material::Kind::glass && !emits(obstacle);
  if (!blocks || scene.luminaires().empty()) return LitSide::either;
  if (for_all_luminaires(scene, obstacle.shape, is_inside)) return LitSide::inside;
  return for_all_luminaires(scene, obstacle.shape, is_outside) ? LitSide::outside : LitSide::either;
}

bool can_occlude(const Scene& scene, std::size_t surface) {
  const Surface& obstacle = scene.surfaces()[surface];
  if (scene.luminaires().size() == 1 && emits(obstacle)) return false;
  if (!obstacle.rectangle) return lit_side(scene, surface) != LitSide::inside;
  const Sphere<double> other_face{obstacle.shape.anchor, -obstacle.shape.normal, 0};
  return !none_beyond(obstacle.shape, scene) && !none_beyond(other_face, scene);
}

}  // namespace fairlight
