#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <fairlight/stats/betting_test.h>
#include <fairlight/stats/manifest.h>

namespace fairlight::detail {

/// Whether `a` says more against a claim than `b`: a worse verdict, then an interval without 0, then a
/// larger bias.
bool is_worse(const Finding& a, const Finding& b);

/// The channel that a message is about: the worst one.
std::size_t worst_channel(const std::vector<Finding>& findings);

/// "channel 1 of 0 to 2: ", or nothing where there is one channel.
std::string channel_name(std::size_t channel, std::size_t channels);

/// What a test that ends before it begins has found: a draw that cannot be, or the end of its
/// draws.
Finding found_in_pilot(const Trial& trial, const BadDraw& bad);
Finding found_in_pilot(const Trial& trial, const NoMoreDraws& spent);

}  // namespace fairlight::detail
