#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/claims/drawn_laws.h>

namespace fairlight {
namespace {

using Values = std::vector<double>;
constexpr auto logarithmic = ParameterRange::Law::logarithmic;

void add_fixed(std::vector<Claim>& claims) {
  add_mean_over(claims, any_azimuth("UniformHemisphere"), [](const Values& v) {
    return fixed_directions<UniformHemisphere>("hemisphere.uniform.integrands", "UniformHemisphere", 0, 1, v[0]);
  });
  add_mean_over(claims, any_azimuth("CosineHemisphere"), [](const Values& v) {
    return fixed_directions<CosineHemisphere>("hemisphere.cosine.integrands", "CosineHemisphere", 1, 1, v[0]);
  });
  add_mean_over(claims, any_azimuth("UniformSphere"), [](const Values& v) {
    return fixed_directions<UniformSphere>("sphere.uniform.integrands", "UniformSphere", 0, 2, v[0]);
  });
  add_mean_over(claims, any_azimuth("ConstantEnvironment"), [](const Values& v) {
    return fixed_directions<EnvironmentDirections>("environment.integrands", "ConstantEnvironment", 0, 2, v[0]);
  });
}

void add_cones(std::vector<Claim>& claims) {
  const auto add = [&](const char* name, ConeBy by, const ParameterRange& range) {
    add_mean_over(claims, {range, {"UniformCone", "azimuth", 0, full_turn}},
                  [=](const Values& v) { return cone_integrands<UniformCone>(name, by, v[0], v[1]); });
  };
  add("cone.integrands.narrow", ConeBy::sine_squared, {"UniformCone", "sin^2", 1e-30, 1e-6, logarithmic});
  add("cone.integrands.sphere", ConeBy::sine_squared, {"UniformCone", "sin^2", 1e-6, 1, logarithmic});
  add("cone.integrands.height", ConeBy::height, {"UniformCone", "1 - cos", 0.01, 2});
}

void add_lobes(std::vector<Claim>& claims) {
  const auto add = [&](const char* name, double low, double high) {
    add_mean_over(claims, lobe_ranges(low, high),
                  [=](const Values& v) { return lobe_integrands<PowerCosineLobe>(name, v); });
  };
  add("lobe.power.integrands.flat", 0, 0);
  add("lobe.power.integrands.broad", 0, 2);
  add("lobe.power.integrands.steep", 2, 30);
  add("lobe.power.integrands.sharp", 30, 1e4);
  add("lobe.power.integrands.sharpest", 1e4, 1e8);
}

void add_filters(std::vector<Claim>& claims) {
  const auto ranges = [](const std::string& filter) {
    return std::vector<ParameterRange>{{filter, "radius", 1e-6, 1e6, logarithmic},
                                       {filter, "azimuth", 0, full_turn}};
  };
  add_mean_over(claims, ranges("BoxFilter"), box_integrands<BoxFilter>);
  add_mean_over(claims, any_azimuth("TentFilter"), tent_integrands<TentFilter>);
  add_mean_over(claims, ranges("BlackmanHarrisFilter"), blackman_harris_integrands<BlackmanHarrisFilter>);
  const auto gaussian = [&](const char* name, double low, double high) {
    add_mean_over(claims,
                  {{"GaussianFilter", "radius", 1e-5, 1e5, logarithmic},
                   {"GaussianFilter", "radius in deviations", low, high, logarithmic},
                   {"GaussianFilter", "azimuth", 0, full_turn}},
                  [=](const Values& v) { return gaussian_integrands<GaussianFilter>(name, v); });
  };
  gaussian("filter.gaussian.integrands.cut", 0.1, 1);
  gaussian("filter.gaussian.integrands.whole", 1, 5);
}

void add_apertures(std::vector<Claim>& claims) {
  add_mean_over(
      claims,
      {{"CircularAperture", "radius", 1e-18, 1e18, logarithmic}, {"CircularAperture", "azimuth", 0, full_turn}},
      circle_integrands<CircularAperture>);
  const auto polygon = [&](const char* name, double low, double high) {
    add_mean_over(claims,
                  {{"PolygonalAperture", "blades", low, high},
                   {"PolygonalAperture", "radius", 1e-18, 1e18, logarithmic},
                   {"PolygonalAperture", "rotation", -full_turn, full_turn},
                   {"PolygonalAperture", "azimuth", 0, full_turn}},
                  [=](const Values& v) { return polygon_integrands<PolygonalAperture>(name, v); });
  };
  polygon("aperture.polygon.integrands.few", 3, 9);
  polygon("aperture.polygon.integrands.many", 9, 1000);
}

}  // namespace

void add_direction_domain_claims(std::vector<Claim>& claims) {
  add_fixed(claims);
  add_cones(claims);
  add_lobes(claims);
  add_filters(claims);
  add_apertures(claims);
}

}  // namespace fairlight
