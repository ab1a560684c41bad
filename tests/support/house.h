#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace fairlight::testing {

/// Checks of the project's own rules, for the sources under `root`. Each returns one sentence per
/// violation, and nothing if there is none.

/// Includes point down the chain stats <- estimators <- render <- validation <- tests, never up.
std::vector<std::string> includes_up_the_chain(const std::filesystem::path& root);

/// Headers of stats/ include only the standard library, Eigen, Boost.Math and each other. Headers
/// that adapt a test framework may also include that framework.
std::vector<std::string> foreign_includes_in_stats(const std::filesystem::path& root);

/// Every component names its Source, and with a density also Formula, Measure, Domain and Random.
/// It has a row in the registry, a test file named after its header, and a section in
/// docs/estimators.md. Components are all classes and functions that headers of estimators/ declare
/// outside of namespace detail, unless non_components.h lists them. Classes of render/ are
/// components if they sample, sum, play, estimate or have a section.
std::vector<std::string> unregistered_components(const std::filesystem::path& root,
                                                 const std::set<std::string>& registered);

/// Every section of docs/estimators.md describes a component that exists.
std::vector<std::string> sections_without_component(const std::filesystem::path& root);

/// Everything that non_components.h lists exists, and has no row in the registry.
std::vector<std::string> stale_non_components(const std::filesystem::path& root,
                                              const std::set<std::string>& registered);

/// Every line of the table of bad input, the last part of docs/estimators.md, names existing tests
/// as `Suite.Test`.
std::vector<std::string> missing_tests_of_bad_input(const std::filesystem::path& root);

}  // namespace fairlight::testing
