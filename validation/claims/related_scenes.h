#pragma once

#include <fairlight/render/built_in_scenes.h>

namespace fairlight {

/// Scenes whose pictures are known from those of other scenes, whatever they show.

/// x -> scale rotation x + shift: changes all lengths by the same factor, and no angle.
struct Similarity {
  double scale = 1;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3<double> shift{0, 0, 0};  ///< [m]

  Vec3<double> direction(const Vec3<double>& w) const { return rotation * w; }
  Vec3<double> point(const Vec3<double>& x) const { return scale * (rotation * x) + shift; }
};

/// The edge of a rectangle from its axis, whose length is the inverse of half the edge.
inline Vec3<double> edge_along(const Vec3<double>& axis) { return 2 * axis / axis.squaredNorm(); }

/// Adds a surface of another scene, moved.
inline void add_moved(Scene& scene, const Surface& surface, const Similarity& move = {}) {
  const Vec3<double> anchor = move.point(surface.shape.anchor);
  if (surface.rectangle) {
    const Vec3<double> x = move.scale * move.direction(edge_along(surface.rectangle->x));
    const Vec3<double> y = move.scale * move.direction(edge_along(surface.rectangle->y));
    scene.add_rectangle(anchor - (x + y) / 2, x, y, surface.material, surface.radiance);
  } else {
    scene.add_wall(anchor, move.direction(surface.shape.normal), move.scale / surface.shape.curvature,
                   surface.material, surface.radiance);
  }
}

/// Rebuilds a scene surface by surface: add(Scene&, surface).
template <class Add>
Scene rebuilt(const Scene& scene, const Add& add) {
  Scene result;
  for (const Surface& surface : scene.surfaces()) add(result, surface);
  return result;
}

inline Scene moved(const Scene& scene, const Similarity& move) {
  return rebuilt(scene, [&](Scene& result, const Surface& surface) { add_moved(result, surface, move); });
}

/// Moves a scene and its camera, so that the picture stays the same.
inline View moved(const View& view, const Similarity& move) {
  CameraSettings camera = view.camera.settings();
  camera.eye = move.point(camera.eye);
  camera.look = move.direction(camera.look);
  camera.up = move.direction(camera.up);
  camera.start *= move.scale;
  camera.aperture_radius *= move.scale;
  camera.focus_distance *= move.scale;
  return {view.name, moved(view.scene, move), Camera(camera)};
}

/// Multiplies all emission by a factor, and with it the picture.
inline Scene with_radiances(const Scene& scene, double factor) {
  return rebuilt(scene, [&](Scene& result, Surface surface) {
    surface.radiance *= factor;
    add_moved(result, surface);
  });
}

/// Multiplies all albedos by a factor, and with it the light that is reflected once.
inline Scene with_albedos(const Scene& scene, double factor) {
  return rebuilt(scene, [&](Scene& result, Surface surface) {
    surface.material.albedo *= factor;
    add_moved(result, surface);
  });
}

/// Reverses the order of the surfaces, and so of the lights.
inline Scene in_reverse_order(const Scene& scene) {
  Scene result;
  for (auto surface = scene.surfaces().rbegin(); surface != scene.surfaces().rend(); ++surface)
    add_moved(result, *surface);
  return result;
}

/// Splits every emitting rectangle in two, along its first edge: the given part of it, and the
/// rest.
inline Scene with_split_lights(const Scene& scene, double part) {
  return rebuilt(scene, [&](Scene& result, const Surface& surface) {
    if (!surface.rectangle || !(surface.radiance > 0).any()) return add_moved(result, surface);
    const Vec3<double> x = edge_along(surface.rectangle->x), y = edge_along(surface.rectangle->y);
    const Vec3<double> corner = surface.shape.anchor - (x + y) / 2;
    result.add_rectangle(corner, part * x, y, surface.material, surface.radiance);
    result.add_rectangle(corner + part * x, (1 - part) * x, y, surface.material, surface.radiance);
  });
}

}  // namespace fairlight
