// Objects of a scene of which nothing is known, because they have no voxeme.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/simulation/scene.h"
#include "continua/voxml/catalogue.h"

namespace continua {

/// The names of the objects that have a voxeme neither of their own name nor of their type, in the scene's order.
std::vector<std::string> objects_without_voxeme(const Scene& scene, const Catalogue& voxemes);

/// A warning that names them, at the scene's path, and a type that is perhaps only misspelt; nothing where each object
/// has its voxeme. Such a scene can be used: without a voxeme, nothing is forbidden. `knowledge` is the folder in which
/// voxemes are, as the warning tells it.
std::optional<Error> warning_of_voxemes(const Scene& scene, const Catalogue& voxemes, const std::string& knowledge);

}  // namespace continua
