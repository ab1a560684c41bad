#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <fairlight/estimators/bsdf.h>
#include <fairlight/estimators/dielectric.h>
#include <fairlight/estimators/glossy.h>
#include <fairlight/estimators/rectangle_light.h>
#include <fairlight/estimators/rough_conductor.h>
#include <fairlight/render/scene.h>
#include <fairlight/stats/text.h>

namespace fairlight {
namespace {

// Checks a material by constructing its BSDF, which throws outside its domain.
void require_material(const Material& material) {
  require_albedo(material.albedo);
  const double number = material.parameter;
  switch (material.kind) {
    case Material::Kind::gloss:
      static_cast<void>(Glossy<double>(material.albedo, number));
      break;
    case Material::Kind::metal:
      static_cast<void>(Ggx<double>(number, number));
      break;
    case Material::Kind::glass:
      static_cast<void>(Dielectric<double>(number));
      break;
    case Material::Kind::diffuse:
    case Material::Kind::mirror:
      break;
  }
}

std::string text(double x) { return formatted("%.3g", x); }

// Lengths whose fourth power, and its inverse, doubles can represent.
void require_length(double length) {
  if (!(length >= 1e-50 && length <= 1e50))
    throw std::invalid_argument("a surface of " + text(length) + " m is not held by doubles (scale the scene)");
}

void require_radius(const Vec3<double>& place, double radius) {
  if (!(radius > 0 && std::isfinite(radius) && place.allFinite()))
    throw std::invalid_argument("a sphere's radius must be positive and finite, and its place finite (in metres)");
  require_length(radius);
}

// The relative precision of a float is 6e-8, and its square must not overflow or vanish. A surface
// smaller than 1e-6 of its distance from the origin would be misplaced by a visible part of its
// size.
void require_floats(double size, double distance) {
  if (size >= 1e-9 && size <= 1e9 && distance <= 1e9 && size >= 1e-6 * distance) return;
  throw std::invalid_argument("a surface of " + text(size) + " m at " + text(distance) +
                              " m from the origin is not held by floats (give --real double)");
}

}  // namespace

double power_of(const Luminaire& light) {
  const double area =
      light.is_rectangle ? light.edge_x.norm() * light.edge_y.norm() : 4 * pi<double> * light.radius * light.radius;
  return pi<double> * area * light.radiance.mean();
}

void Scene::add_sphere(const Vec3<double>& centre, double radius, const Material& material,
                       const Rgb<double>& radiance) {
  require_radius(centre, radius);
  const Vec3<double> up(0, 1, 0);
  const Sphere<double> shape{centre + radius * up, up, 1 / radius};
  add({shape, {}, material, radiance}, {.centre = centre, .radius = radius, .is_rectangle = false});
}

void Scene::add_wall(const Vec3<double>& point, const Vec3<double>& outward, double radius,
                     const Material& material, const Rgb<double>& radiance) {
  require_radius(point, radius);
  if (!(std::abs(outward.norm() - 1) <= 1e-9))
    throw std::invalid_argument("a wall's normal must be a unit vector (it is the direction away from the centre)");
  add({{point, outward, 1 / radius}, {}, material, radiance},
      {.centre = point - radius * outward, .radius = radius, .is_rectangle = false});
}

void Scene::add_rectangle(const Vec3<double>& corner, const Vec3<double>& edge_x, const Vec3<double>& edge_y,
                          const Material& material, const Rgb<double>& radiance) {
  static_cast<void>(RectangleLight<double>(corner, edge_x, edge_y));  // it knows what a rectangle is
  require_length(edge_x.norm());
  require_length(edge_y.norm());
  if (material.kind == Material::Kind::glass)
    throw std::invalid_argument("a rectangle cannot be of glass (it has no inside; use a sphere)");
  const Vec3<double> middle = corner + (edge_x + edge_y) / 2;
  const Sphere<double> plane{middle, edge_x.cross(edge_y).normalized(), 0};
  const Rectangle<double> rectangle{plane, 2 * edge_x / edge_x.squaredNorm(), 2 * edge_y / edge_y.squaredNorm()};
  add({plane, rectangle, material, radiance}, {.centre = middle,
                                               .radius = (edge_x + edge_y).norm() / 2,
                                               .is_rectangle = true,
                                               .edge_x = edge_x,
                                               .edge_y = edge_y});
}

void Scene::add(const Surface& surface, Luminaire luminaire) {
  require_material(surface.material);
  if (!((surface.radiance >= 0).all() && surface.radiance.isFinite().all()))
    throw std::invalid_argument("a radiance must be nonnegative and finite per channel");
  luminaire.surface = static_cast<int>(surfaces_.size());
  luminaire.radiance = surface.radiance;
  surfaces_.push_back(surface);
  if ((surface.radiance > 0).any()) luminaires_.push_back(luminaire);
}

void require_floats(const Scene& scene) {
  for (const Surface& surface : scene.surfaces()) {
    const double distance = surface.shape.anchor.norm();
    if (surface.rectangle) {
      require_floats(2 / surface.rectangle->x.norm(), distance);
      require_floats(2 / surface.rectangle->y.norm(), distance);
    } else {
      require_floats(1 / surface.shape.curvature, distance);
    }
    for (const double channel : surface.radiance) {
      if (channel == 0 || (channel >= 1e-18 && channel <= 1e18)) continue;
      throw std::invalid_argument("a radiance of " + text(channel) + " is not held by floats (give --real double)");
    }
  }
}

}  // namespace fairlight
