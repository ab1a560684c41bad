#pragma once

#include <map>
#include <string>

namespace fairlight::testing {

/// Headers, classes and functions of estimators/ that are not components, and why: they have no
/// distribution, mean or reflectance to make a claim about. Every other declaration is a component,
/// so a new header counts as one until it is listed here.

/// Headers, with everything in them.
inline const std::map<std::string, std::string> headers_without_components{
    {"allocation_stages.h", "stages that the allocations are made of"},
    {"bound.h", "arithmetic of ranges"},
    {"bsdf.h", "what a surface must have"},
    {"concepts.h", "what a component must have"},
    {"density.h", "a number and its measure"},
    {"safe_divide.h", "a division"},
    {"gauss.h", "a quadrature rule"},
    {"light_sample.h", "what a light must have"},
    {"packet.h", "arithmetic"},
    {"packet_words.h", "arithmetic"},
    {"ranges.h", "checks of parameters"},
    {"real.h", "arithmetic"},
    {"strata.h", "permutations of cells: Stratified, LatinHypercube and PaddedStrata are made of them"},
    {"table.h", "a look-up"},
    {"vec.h", "arithmetic"},
};

/// Classes and functions of other headers.
inline const std::map<std::string, std::string> no_components{
    {"Fixed64", "the words that a number is made of"},
    {"GgxLoss",
     "a fit of ggx_loss, held to it by its test: a part of EnergyCompensatedConductor, whose furnaces see it"},
    {"LensRay", "a ray and its weight: what ThinLens gives"},
    {"PathVertex", "the place of a vertex"},
    {"Philox", "the function of PhiloxStream, with known answers"},
    {"Pick", "an index and its probability: what a choice gives"},
    {"PixelGrid", "places of pixels"},
    {"RectangleLight", "the shape and power that RectangleByArea and RectangleBySolidAngle sample"},
    {"SphericalRectangle", "the geometry of RectangleBySolidAngle"},
    {"SphericalTriangle", "the geometry of TriangleBySolidAngle"},
    {"Replicate", "the words of a point set"},
    {"SampleSets", "the base of PaddedSobol and PaddedStrata"},
    {"SphereLight", "the shape and radiance that the samplers of spheres share"},
    {"SphereFromPoint", "the geometry of SphereByCone"},
    {"StreamKey", "the key of a stream"},
    {"Survival", "what a roulette gives"},
    {"TriangleLight", "the shape that TriangleByArea and TriangleBySolidAngle sample"},
    {"WeightedLobe", "a lobe and its numbers: what a Mixture is given"},
    {"checked_number", "a check"},
    {"checked_size", "a check"},
    {"five_of", "how a block is spread over numbers"},
    {"ggx_albedo", "a quadrature without random numbers: RoughConductor's albedo, held to another by its test"},
    {"ggx_loss", "1 less ggx_albedo"},
    {"in_cell", "a step of StratifiedMean"},
    {"independent_digits", "the words of IndependentNumbers"},
    {"mirrored", "the direction of Mirror, elementary"},
    {"mis_factor", "a weight over a density: a step of MultiSampleMis and OneSampleMis"},
    {"mixed_bits", "a hash: a step of SampleSets"},
    {"mixture_bound", "arithmetic of ranges"},
    {"nested_scramble", "a step of OwenSobol"},
    {"point_numbers", "which points lanes have"},
    {"require_conductor", "a check"},
    {"reverse_bits", "a step of OwenSobol"},
    {"scramble_upwards", "a step of OwenSobol"},
    {"second_sobol_reversed", "a step of PaddedSobol"},
    {"share_out", "whole numbers from shares: a step of every allocation"},
    {"shuffled", "an order: a step of SampleSets"},
    {"sobol", "a step of OwenSobol"},
    {"sobol_directions", "a table of OwenSobol"},
    {"unit_number", "a word as a number: a step of PhiloxStream"},
    {"unit_number_of_halves", "a step of PhiloxStream"},
    {"unit_numbers", "a step of VertexSource"},
    {"vertex_words", "a step of VertexSource"},
};

}  // namespace fairlight::testing
