// Voxemes from VoxML documents as they are published: XML with a root VoxML and the elements Entity, Lex, Type,
// Habitat, Afford_Str, Embodiment and Attributes, in any order and each of them optional but Entity and Lex/Pred.
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
  /// At "path:line": elements and attributes that are unknown and formulas that cannot be read; both are kept, as text,
  /// in Voxeme::others.
  std::vector<Error> notes;
};

/// Text in US-ASCII, UTF-8, UTF-16 or ISO 8859-1, by its marks and its XML declaration, before which comments may
/// stand. Prefixes of namespaces are passed over. The error, at "path:line", names the text that is no XML, or no
/// VoxML.
Result<ReadVoxeme> read_voxeme(std::string_view text, const std::string& path);

/// Is it XML with a root VoxML, as far as its beginning tells?
bool looks_like_voxeme(std::string_view text);

struct ReadCatalogue;

/// Voxemes by name.
class Catalogue {
 public:
  /// Replaces the voxeme of the same entity and predicate.
  void add(Voxeme voxeme);

  /// The voxeme, or nullptr.
  const Voxeme* find(Voxeme::Entity entity, std::string_view predicate) const;
  /// That of an object of the scene: by its own name, else by its type; nullptr if it has none.
  const Voxeme* for_object(std::string_view name, std::string_view type) const;

  /// By entity and predicate.
  const std::map<std::pair<Voxeme::Entity, std::string>, Voxeme>& voxemes() const { return voxemes_; }

  /// Of the documents that were read and their paths below the folder; empty without any.
  const std::string& digest() const { return digest_; }

 private:
  friend ReadCatalogue read_catalogue(const std::string& folder);

  std::map<std::pair<Voxeme::Entity, std::string>, Voxeme> voxemes_;
  std::string digest_;
};

struct ReadCatalogue {
  Catalogue catalogue;
  std::vector<Error> problems;  ///< of documents that were left out
  std::vector<Error> notes;     ///< those of the documents, and where a later one replaces an earlier one
  std::size_t documents = 0;    ///< that were read
};

/// Every *.xml below `folder`, in the order of their paths; nothing where there is no such folder.
ReadCatalogue read_catalogue(const std::string& folder);

std::string_view name_of(Voxeme::Entity entity);

}  // namespace continua
