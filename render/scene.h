#pragma once

#include <optional>
#include <vector>

#include <fairlight/render/rectangle.h>

namespace fairlight {

/// The material of a surface: its kind, its albedo and the kind's parameter.
struct Material {
  enum class Kind {
    diffuse,  ///< Lambertian
    gloss,    ///< Glossy; parameter: exponent
    metal,    ///< RoughConductor with GGX, reflectance: albedo; parameter: roughness
    mirror,   ///< Mirror
    glass,    ///< Dielectric; parameter: index of refraction; albedo 1
  };
  static constexpr int kinds = 5;

  /// A diffuse material from any colour expression.
  template <class Colour>
  Material(const Eigen::ArrayBase<Colour>& reflectance) : albedo(reflectance) {}  // NOLINT: a colour is a material
  Material(Kind k, const Rgb<double>& reflectance, double number)
      : kind(k), albedo(reflectance), parameter(number) {}

  Kind kind = Kind::diffuse;
  Rgb<double> albedo;  ///< in [0,1] per channel
  double parameter = 1;
};

/// A surface: its shape, material and emission.
struct Surface {
  Sphere<double> shape;  ///< or, for a rectangle, its plane
  std::optional<Rectangle<double>> rectangle;
  Material material;
  Rgb<double> radiance;  ///< emitted, the same in all directions and from both sides [W/(sr m^2)]
};

/// A surface that emits, in the form that light samplers need.
struct Luminaire {
  int surface = -1;               ///< its index in the scene
  Vec3<double> centre{0, 0, 0};   ///< [m]
  double radius = 0;              ///< of the sphere, or of the rectangle's circumscribed circle [m]
  Rgb<double> radiance{0, 0, 0};  ///< [W/(sr m^2)]
  bool is_rectangle = false;
  Vec3<double> edge_x{0, 0, 0}, edge_y{0, 0, 0};  ///< of a rectangle [m]
};

/// The power emitted by each side of a luminaire: pi times its area times the mean of its
/// radiance's channels [W].
double power_of(const Luminaire& light);

/// A ray. The direction is a unit vector.
template <class Real>
struct Ray {
  Vec3<Real> origin;
  Vec3<Real> direction;
  Real origin_primitive;  ///< the index of the surface that the ray starts on, or -1
};

/// The first hit of a ray. Without a hit the index is -1 and the distance infinite.
template <class Real>
struct Hit {
  Real distance;
  Real surface;
};

/// Spheres and rectangles, some of which emit.
class Scene {
 public:
  /// Adds a sphere by centre and radius [m]. Throws std::invalid_argument for a radius outside
  /// [1e-50, 1e50], an albedo outside [0,1], a material parameter outside its domain, or a radiance
  /// that is negative or not finite.
  void add_sphere(const Vec3<double>& centre, double radius, const Material& material, const Rgb<double>& radiance);

  /// Adds a wall: the sphere of the given radius [m] through `point`, with the outward unit normal
  /// `outward` there. Exact for any radius. Throws as add_sphere does, and when the normal's length
  /// differs from 1 by more than 1e-9.
  void add_wall(const Vec3<double>& point, const Vec3<double>& outward, double radius, const Material& material,
                const Rgb<double>& radiance);

  /// Adds a rectangle by a corner and its edges from there [m]. Throws as add_sphere does, for
  /// edges that are not orthogonal or not in [1e-50, 1e50], and for glass, which needs an inside.
  void add_rectangle(const Vec3<double>& corner, const Vec3<double>& edge_x, const Vec3<double>& edge_y,
                     const Material& material, const Rgb<double>& radiance);

  const std::vector<Surface>& surfaces() const { return surfaces_; }
  const std::vector<Luminaire>& luminaires() const { return luminaires_; }

 private:
  void add(const Surface& surface, Luminaire luminaire);

  std::vector<Surface> surfaces_;
  std::vector<Luminaire> luminaires_;
};

/// Throws std::invalid_argument unless floats can represent the scene: surfaces from 1e-9 to 1e9 m,
/// none smaller than 1e-6 of its distance from the origin; radiances of 0, or from 1e-18 to 1e18.
void require_floats(const Scene& scene);

}  // namespace fairlight
