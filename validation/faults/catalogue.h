#pragma once

#include <string>
#include <vector>

#include <fairlight/validation/checks/claim.h>

namespace fairlight {

/// A wrong estimator that the claims must catch.
struct Fault {
  std::string name;
  std::string kind;           ///< its class, as in the record of bugs that projects shipped
  std::string source;         ///< where such a bug is recorded
  std::vector<Claim> claims;  ///< rows of the registry, by name, with the wrong component in place of the right one
  std::vector<Claim> passed{};  ///< rows that it passes: errors that cancel there, or leave the mean unchanged
  std::string survives{};       ///< why no row of it is expected to catch it; or empty
};

const std::vector<Fault>& fault_catalogue();

/// The parts of the catalogue, each in its own file.
std::vector<Fault> direction_faults();
std::vector<Fault> microfacet_faults();
std::vector<Fault> material_faults();
std::vector<Fault> light_faults();
std::vector<Fault> light_domain_faults();
std::vector<Fault> triangle_faults();
std::vector<Fault> combinator_faults();
std::vector<Fault> combinator_domain_faults();
std::vector<Fault> random_faults();
std::vector<Fault> camera_faults();
std::vector<Fault> allocation_faults();
std::vector<Fault> path_tracer_faults();
std::vector<Fault> direct_light_faults();
std::vector<Fault> relation_faults();
std::vector<Fault> second_order_faults();
std::vector<Fault> whole_domain_faults();
std::vector<Fault> picture_faults();

}  // namespace fairlight
