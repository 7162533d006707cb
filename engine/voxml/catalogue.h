// Reads voxemes from VoxML documents as they are published: XML with a root VoxML and the elements Entity, Lex, Type,
// Habitat, Afford_Str, Embodiment and Attributes, in any order. All are optional except Entity and Lex/Pred.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/result.h"
#include "continua/voxml/voxeme.h"

namespace continua {

struct ReadVoxeme {
  Voxeme voxeme;
  /// Unknown elements and attributes, and formulas that cannot be read, at "path:line". They are kept, as text, in
  /// Voxeme::others.
  std::vector<Error> notes;
};

/// Reads a document in US-ASCII, UTF-8, UTF-16 or ISO 8859-1, by its byte order mark and its XML declaration; comments
/// may stand before the declaration. Namespace prefixes are ignored. The error, at "path:line", names the part that is
/// not XML, or not VoxML.
Result<ReadVoxeme> read_voxeme(std::string_view text, const std::string& path);

/// Whether the text begins like XML with a root VoxML.
bool looks_like_voxeme(std::string_view text);

struct ReadCatalogue;

/// Voxemes by entity and predicate.
class Catalogue {
 public:
  /// Replaces the voxeme of the same entity and predicate.
  void add(Voxeme voxeme);

  /// The voxeme, or nullptr.
  const Voxeme* find(Voxeme::Entity entity, std::string_view predicate) const;
  /// The voxeme of an object of the scene: by its own name, else by its type; nullptr if it has none.
  const Voxeme* for_object(std::string_view name, std::string_view type) const;

  /// All voxemes, by entity and predicate.
  const std::map<std::pair<Voxeme::Entity, std::string>, Voxeme>& voxemes() const { return voxemes_; }

  /// Digest of the documents and their paths below the folder; empty without documents.
  const std::string& digest() const { return digest_; }

 private:
  friend ReadCatalogue read_catalogue(const std::string& folder);

  std::map<std::pair<Voxeme::Entity, std::string>, Voxeme> voxemes_;
  std::string digest_;
};

struct ReadCatalogue {
  Catalogue catalogue;
  std::vector<Error> problems;  ///< of documents that were left out
  std::vector<Error> notes;     ///< of the documents, and of voxemes that replace earlier ones
  std::size_t documents = 0;    ///< number of documents read
};

/// Reads every *.xml below `folder`, in the order of their paths. Without such a folder the result is empty.
ReadCatalogue read_catalogue(const std::string& folder);

std::string_view name_of(Voxeme::Entity entity);

}  // namespace continua
