#pragma once
#include <functional>
#include <random>
#include <string>

namespace cardioid::test {

/// Changes, cuts, doubles or inserts some bytes, at places and of values that readers stumble over.
std::string mutated(std::string text, std::mt19937& random);

/// Damages of each sample: CARDIOID_MUTATIONS, else 2000.
std::size_t mutations();

/// What a reader may do with a broken file is to throw Error; anything else ends the test. Takes one of `share`
/// damages: readers of files wait for the disk.
void survive(const std::string& sample, unsigned seed, const std::function<void(const std::string&)>& read,
             std::size_t share = 1);

}  // namespace cardioid::test
