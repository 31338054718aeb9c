#pragma once
#include <functional>
#include <random>
#include <string>

namespace cardioid::test {

/// Changes, cuts, doubles or inserts some bytes, words and numbers, at places and of values that readers stumble over.
std::string mutated(std::string text, std::mt19937& random);

/// Damages of each sample: CARDIOID_MUTATIONS, else 1000.
std::size_t mutations();

/// What a reader may do with a broken file is to throw Error; anything else ends the test: a crash, a reader that takes
/// more than a gigabyte, or more than twenty seconds. The text that did it is left in "damaged" in the working folder.
void survive(const std::string& sample, unsigned seed, const std::function<void(const std::string&)>& read);

}  // namespace cardioid::test
