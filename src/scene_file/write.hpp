// Writes scene files.
#pragma once
#include <string>

#include "ritz/scene/scene.hpp"

namespace ritz::scene {

/// The scene as the text of a scene file, from which `parse` makes the same scene: numbers keep all their digits.
/// Throws InputError for a name that is not UTF-8, which no scene file can hold.
std::string written(const Scene& scene);

}  // namespace ritz::scene
