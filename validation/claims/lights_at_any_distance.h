#pragma once

#include <string>
#include <utility>
#include <vector>

#include <fairlight/estimators/hemisphere.h>
#include <fairlight/validation/claims/placed_lights.h>

namespace fairlight {

/// The irradiance from lights at places that each run draws anew, by every sampling of lights. A row
/// has three lights, one for each channel, whose ranges are parts of a range. So a length in the
/// code that is written in, such as a floor under a distance, shows in a channel.

/// What bounds 1/p.
enum class BoundOfLight { area, half_of_area, solid_angle };

inline double bound_of(const PlacedRectangle& rectangle, BoundOfLight by) {
  return by == BoundOfLight::solid_angle ? rectangle.solid_angle() : rectangle.area_bound();
}
/// Inside the sphere, the visible hemisphere is the whole of it.
inline double bound_of(const PlacedSphere& sphere, BoundOfLight by) {
  if (by == BoundOfLight::solid_angle) return sphere.cone_bound();
  return by == BoundOfLight::half_of_area && !sphere.inside() ? sphere.area_bound() / 2 : sphere.area_bound();
}

/// The three lights of a row.
template <class Placed>
using ThreeLights = std::array<Placed, 3>;

namespace detail {

template <class Placed>
std::vector<Reference> irradiances(const ThreeLights<Placed>& lights, const auto& largest) {
  return for_channels([&](int c) {
    const Placed& light = lights[static_cast<std::size_t>(c)];
    return Reference{light.irradiance(), 0, largest(light) * (1 + 1e-9)};
  });
}

}  // namespace detail

/// Their irradiances by draws of cos / p. A draw has a factor that is 1 if its distance is that of
/// the light.
template <template <class> class Strategy, class Placed>
auto irradiance_of_placed(const std::string& name, const std::string& subject, BoundOfLight by,
                          const ThreeLights<Placed>& lights, double margin_factor) {
  const auto draw = [lights]<class Real>(std::type_identity<Real>, auto& numbers) {
    Rgb<Real> drawn;
    for (std::size_t c = 0; c < 3; ++c) {
      const Strategy<Real> light(lights[c].template light<Real>());
      const LightSample<Real> sample =
          light.sample(rounded_vector<Real>(lights[c].point), next_pair<Real>(numbers));
      const Real cosine = rounded_vector<Real>(lights[c].normal).dot(sample.direction);
      const Real received = select(cosine > Real(0), cosine, Real(0));
      drawn[static_cast<int>(c)] =
          safe_divide(Real(received * lights[c].template on_light<Real>(sample)), sample.density);
    }
    return drawn;
  };
  return estimand(
      name, {subject}, "lights at drawn places, of drawn sizes, make the irradiance of Lambert's contour formula",
      "Lambert 1760; Snyder 1996",
      detail::irradiances(lights, [by](const Placed& light) { return bound_of(light, by); }), draw, margin_factor);
}

/// The same from a sample of the light and one of the cosine, which may meet it. They share the light
/// by the balance heuristic, so the density of met directions counts too.
/// Bound    both draws are at most cos / p of the cosine, which is pi
template <template <class> class Strategy, class Placed>
auto shared_irradiance_of_placed(const std::string& name, const std::string& subject,
                                 const ThreeLights<Placed>& lights, double margin_factor) {
  const auto draw = [lights]<class Real>(std::type_identity<Real>, auto& numbers) {
    Rgb<Real> drawn;
    for (std::size_t c = 0; c < 3; ++c) {
      const Strategy<Real> light(lights[c].template light<Real>());
      const Vec3<Real> from = rounded_vector<Real>(lights[c].point),
                       normal = rounded_vector<Real>(lights[c].normal);
      const auto shared = [&](const Vec3<Real>& w, const Density<SolidAngle, Real>& density) {
        const Real cosine = normal.dot(w);
        const Real by_cosine = cosine / pi<Real>;
        const Mask<Real> counts = density.value() > Real(0) && cosine > Real(0);
        return select(counts, Real(cosine / select(counts, Real(density.value() + by_cosine), Real(1))), Real(0));
      };
      const LightSample<Real> sample = light.sample(from, next_pair<Real>(numbers));
      const Vec3<Real> bounce =
          Frame<Real>(normal).to_world(CosineHemisphere<Real>().sample(next_pair<Real>(numbers)));
      drawn[static_cast<int>(c)] =
          shared(sample.direction, sample.density) + shared(bounce, light.pdf(from, bounce));
    }
    return drawn;
  };
  return estimand(name, {subject, "CosineHemisphere"},
                  "lights at drawn places make the irradiance of Lambert's contour formula, from a sample of the "
                  "light and one of the cosine together",
                  "Lambert 1760; Snyder 1996; Veach and Guibas 1995",
                  detail::irradiances(lights, [](const Placed&) { return 2 * std::numbers::pi; }), draw,
                  margin_factor);
}

/// The parameters of three rectangles. The faces of the first and the last are lit, of the second the
/// back.
inline std::vector<ParameterRange> three_rectangles(const std::string& light,
                                                    const std::array<RectangleRange, 3>& ranges) {
  std::vector<ParameterRange> all;
  for (std::size_t c = 0; c < 3; ++c) add_rectangle_ranges(all, light, ranges[c], c != 1);
  return all;
}

inline ThreeLights<PlacedRectangle> placed_rectangles(const std::vector<double>& values) {
  DrawnValues next(values);
  ThreeLights<PlacedRectangle> lights;
  for (PlacedRectangle& light : lights) light = placed_rectangle(next);
  return lights;
}

/// The parameters of three spheres.
inline std::vector<ParameterRange> three_spheres(const std::string& light,
                                                 const std::array<SphereRange, 3>& ranges) {
  std::vector<ParameterRange> all;
  for (const SphereRange& range : ranges) add_sphere_ranges(all, light, range);
  return all;
}

inline ThreeLights<PlacedSphere> placed_spheres(const std::array<SphereRange, 3>& ranges,
                                                const std::vector<double>& values) {
  DrawnValues next(values);
  ThreeLights<PlacedSphere> lights;
  for (std::size_t c = 0; c < 3; ++c) lights[c] = placed_sphere(next, ranges[c].place);
  return lights;
}

/// A row of three ranges, and its name.
template <class Range>
struct LightRanges {
  const char* name;
  std::array<Range, 3> ranges;
};

/// From 1 nm to 1e9 m. `size` of the middle: much larger than the distance, very long, small.
inline constexpr std::array<LightRanges<RectangleRange>, 3> rectangle_distances{
    {{"near",
      {{{{1e-9, 1e-6}, {0.5, 2}, {0.2, 1}},
        {{1e-6, 1e-3}, {0.1, 2}, {1e-3, 1}},
        {{1e-3, 0.09}, {0.1, 2}, {1e-3, 1}}}}},
     {"middle",
      {{{{0.09, 10}, {1, 4}, {0.2, 1}},
        {{0.09, 10}, {1, 10}, {1e-5, 1e-2}},
        {{0.09, 10}, {1e-5, 0.1}, {1e-3, 1}}}}},
     {"far",
      {{{{10, 1e3}, {0.1, 2}, {1e-3, 1}}, {{1e3, 1e6}, {0.1, 2}, {1e-3, 1}}, {{1e6, 1e9}, {0.5, 2}, {1e-6, 1}}}}}}};

/// Rectangles overhead that are much longer than their distance, seen from the origin. Their sides
/// are along the axes, as floats hold no plane so near in another orientation.
inline std::vector<ParameterRange> three_near_planes(const std::string& light) {
  std::vector<ParameterRange> all;
  for (const auto& [low, high] : {std::pair{10.0, 100.0}, {100.0, 1e4}, {1e4, 1e6}}) {
    const std::vector<ParameterRange> more{detail::in_decades(light, "distance", 1e-6, 1e3),
                                           detail::in_decades(light, "size / distance", low, high),
                                           detail::in_decades(light, "shorter / longer side", 1e-4, 1),
                                           {light, "foot along a side", 0.05, 0.95},
                                           {light, "foot along a side", 0.05, 0.95},
                                           {light, "cosine at the surface", 0.3, 1},
                                           {light, "azimuth at the surface", 0, full_turn_of_light}};
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

/// The plane of rectangle c is across axis c; the second one is on its other side.
inline ThreeLights<PlacedRectangle> placed_near_planes(const std::vector<double>& values) {
  DrawnValues next(values);
  ThreeLights<PlacedRectangle> lights;
  for (int c = 0; c < 3; ++c) {
    const Vec3<double> x = Vec3<double>::Unit((c + 1) % 3), y = Vec3<double>::Unit((c + 2) % 3);
    const Vec3<double> across = Vec3<double>::Unit(c) * (c == 1 ? -1 : 1);
    const double distance = next.next(), longer = next.next() * distance, shorter = next.next() * longer;
    const double foot_x = next.next(), foot_y = next.next(), cosine = next.next();
    lights[static_cast<std::size_t>(c)] = {.point = Vec3<double>::Zero(),
                                           .normal = detail::direction_about(across, cosine, next.next()),
                                           .corner = distance * across - foot_x * longer * x - foot_y * shorter * y,
                                           .edge_x = longer * x,
                                           .edge_y = shorter * y};
  }
  return lights;
}

/// The same of spheres: near the surface, below the horizon in part, small. `largest` is the largest
/// radius divided by the distance: by area, draws from nearer vary much.
constexpr std::array<LightRanges<SphereRange>, 3> sphere_distances(double largest) {
  constexpr auto cut = PlaceAtSphere::cut;
  const SphereRange above{{1e-6, 1e-3}, {0.1, largest}, {0.05, 1}};
  const SphereRange below{{1e-3, 0.09}, {0.3, largest}, {-0.2, 1}, cut};
  const auto at = [](SphereRange range, double low, double high) {
    range.distance = {low, high};
    return range;
  };
  return {{{"near", {at(above, 1e-9, 1e-6), above, below}},
           {"middle",
            {SphereRange{{0.09, 10}, {largest - 0.1, largest}, {0.05, 1}}, at(below, 0.09, 10),
             SphereRange{{0.09, 10}, {1e-8, 0.1}, {0.05, 1}}}},
           {"far", {at(below, 10, 1e3), at(above, 1e3, 1e6), SphereRange{{1e6, 1e9}, {1e-16, 0.1}, {0.05, 1}}}}}};
}

}  // namespace fairlight
