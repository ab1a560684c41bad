#pragma once

#include <optional>
#include <vector>

#include <fairlight/render/rectangle.h>

namespace fairlight {

/// What a surface does with light, and the number that its kind has besides the albedo.
struct Material {
  enum class Kind {
    diffuse,  ///< Lambertian
    gloss,    ///< Glossy; its exponent
    metal,    ///< RoughConductor of GGX facets, of the albedo's reflectance; its roughness
    mirror,   ///< Mirror
    glass,    ///< Dielectric; its index. Albedo 1
  };
  static constexpr int kinds = 5;

  /// A diffuse surface, of any expression of a colour.
  template <class Colour>
  Material(const Eigen::ArrayBase<Colour>& reflectance) : albedo(reflectance) {}  // NOLINT: a colour is a material
  Material(Kind k, const Rgb<double>& reflectance, double number)
      : kind(k), albedo(reflectance), parameter(number) {}

  Kind kind = Kind::diffuse;
  Rgb<double> albedo;  ///< in [0,1] per channel
  double parameter = 1;
};

/// A surface's shape, what it does with light, and what it emits.
struct Surface {
  Sphere<double> shape;  ///< or a plane, of which `rectangle` is a part
  std::optional<Rectangle<double>> rectangle;
  Material material;
  Rgb<double> radiance;  ///< emitted, the same in all directions and from both sides [W/(sr m^2)]
};

/// A surface that emits, as a sphere or a rectangle to be sampled.
struct Luminaire {
  int surface = -1;               ///< its index in the scene
  Vec3<double> centre{0, 0, 0};   ///< [m]
  double radius = 0;              ///< of a sphere, or of the circle about a rectangle [m]
  Rgb<double> radiance{0, 0, 0};  ///< [W/(sr m^2)]
  bool is_rectangle = false;
  Vec3<double> edge_x{0, 0, 0}, edge_y{0, 0, 0};  ///< of a rectangle [m]
};

/// The power that leaves each face of a luminaire, pi times its area and the mean of its radiance's channels [W].
double power_of(const Luminaire& light);

/// A half line. The direction is a unit vector.
template <class Real>
struct Ray {
  Vec3<Real> origin;
  Vec3<Real> direction;
  Real origin_primitive;  ///< the index of the surface that it starts on, or -1
};

/// Where a ray first meets a surface; the index is -1 and the distance infinite where it meets none.
template <class Real>
struct Hit {
  Real distance;
  Real surface;
};

/// Spheres and rectangles, some of which emit.
class Scene {
 public:
  /// A sphere by centre and radius [m]. Throws std::invalid_argument for a radius outside [1e-50, 1e50],
  /// an albedo outside [0,1], a material's number outside its domain, or a radiance that is negative or not finite.
  void add_sphere(const Vec3<double>& centre, double radius, const Material& material, const Rgb<double>& radiance);

  /// A wall: the sphere of the given radius [m] that passes through `point` with the outward unit normal `outward`
  /// there. Exact for any radius. Throws as add_sphere, and when the normal is not a unit vector to 1e-9.
  void add_wall(const Vec3<double>& point, const Vec3<double>& outward, double radius, const Material& material,
                const Rgb<double>& radiance);

  /// A rectangle by a corner and the edges from it [m]. Throws as add_sphere, and unless the edges are in [1e-50, 1e50] and
  /// orthogonal; for glass, which is the inside of something.
  void add_rectangle(const Vec3<double>& corner, const Vec3<double>& edge_x, const Vec3<double>& edge_y,
                     const Material& material, const Rgb<double>& radiance);

  const std::vector<Surface>& surfaces() const { return surfaces_; }
  const std::vector<Luminaire>& luminaires() const { return luminaires_; }

 private:
  void add(const Surface& surface, Luminaire luminaire);

  std::vector<Surface> surfaces_;
  std::vector<Luminaire> luminaires_;
};

/// Throws std::invalid_argument unless floats hold the scene: surfaces from 1e-9 to 1e9 m, and at least a part of 1e-6 of their
/// distance from the origin; radiances that are 0, or from 1e-18 to 1e18.
void require_floats(const Scene& scene);

}  // namespace fairlight
