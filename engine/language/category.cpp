#include "continua/language/category.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "continua/core/located_json.h"

namespace continua {
namespace {

constexpr int deepest = 32;

std::vector<std::string> names_of(const Atoms& atoms) {
  std::vector<std::string> names;
  for (const auto& [name, atom] : atoms) names.push_back(name);
  return names;
}

}  // namespace

struct Category::Node {
  // of the atom, or of the one that a function makes in the end
  Name name{""};
  std::size_t number = 0;
  // for an atom
  bool has_features = false;
  std::optional<Name> feature;
  // for a function
  std::optional<Category> result, argument;
  Slash slash = Slash::forward;
  bool composes = true;
  std::size_t size = 1;
  // Categories that differ in one of these are different: without features and ways to compose, and with them.
  std::size_t shape = 0, whole = 0;

  /// The node with these members and its digests.
  static std::shared_ptr<const Node> made(Node node) {
    const auto mixed = [](std::size_t a, std::size_t b) { return a * 0x9e3779b97f4a7c15 + (a >> 32) + b; };
    if (node.result) {
      const auto &of = *node.result->node_, &over = *node.argument->node_;
      const auto slash = static_cast<std::size_t>(node.slash);
      node.name = of.name;
      node.number = of.number;
      node.shape = mixed(mixed(of.shape, over.shape), slash);
      node.whole = mixed(mixed(of.whole, over.whole), 2 * slash + (node.composes ? 1 : 0));
    } else {
      node.shape = Name::Hash()(node.name);
      node.whole = mixed(node.shape, node.feature ? Name::Hash()(*node.feature) : 0);
    }
    return std::make_shared<const Node>(std::move(node));
  }
};

class CategoryParser {
 public:
  CategoryParser(std::string_view text, const Atoms& atoms) : text_(text), atoms_(atoms) {}

  Result<Category> whole() {
    auto category = sequence(0);
    if (category && at_ < text_.size()) return error(fmt::format("found {}, expected / or \\", rest()));
    return category;
  }

 private:
  Result<Category> sequence(int depth) {
    auto left = part(depth);
    while (left && at_ < text_.size() && (text_[at_] == '/' || text_[at_] == '\\')) {
      const auto slash = text_[at_++] == '/' ? Category::Slash::forward : Category::Slash::backward;
      const bool composes = at_ >= text_.size() || text_[at_] != '*';
      if (!composes) ++at_;
      auto right = part(depth);
      if (!right) return right;
      if (left->size() + right->size() > deepest) return error("a category of more than 32 atoms");
      left = Category::function(*left, slash, *right, composes);
    }
    return left;
  }

  Result<Category> part(int depth) {
    if (depth > deepest) return error("parentheses nested deeper than 32");
    if (at_ >= text_.size() || text_[at_] != '(') return atom();
    ++at_;
    auto inner = sequence(depth + 1);
    if (!inner) return inner;
    if (at_ >= text_.size() || text_[at_] != ')') return error(fmt::format("found {}, expected )", rest()));
    ++at_;
    return inner;
  }

  Result<Category> atom() {
    const auto begin = at_;
    const auto name = word();
    const auto known = atoms_.find(name);
    if (known == atoms_.end()) {
      const auto found = name.empty() ? rest() : in_quotes(name);
      at_ = begin;
      return error(fmt::format("found {}, expected a category{}", found, did_you_mean(name, names_of(atoms_))));
    }
    Category::Node node;
    node.name = Name(name);
    node.number = static_cast<std::size_t>(std::distance(atoms_.begin(), known));
    const auto& features = known->second.features;
    node.has_features = !features.empty();
    if (at_ < text_.size() && text_[at_] == '[') {
      ++at_;
      const auto place = at_;
      const auto feature = word();
      if (std::find(features.begin(), features.end(), feature) == features.end()) {
        at_ = place;
        return error(fmt::format("{} has no feature {}{}", name, in_quotes(feature), did_you_mean(feature, features)));
      }
      if (at_ >= text_.size() || text_[at_] != ']') return error(fmt::format("found {}, expected ]", rest()));
      ++at_;
      node.feature = Name(feature);
    }
    return Category(Category::Node::made(std::move(node)));
  }

  std::string word() {
    const auto begin = at_;
    while (at_ < text_.size() && std::string_view("/\\()[]* ").find(text_[at_]) == std::string_view::npos) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }
  std::string rest() const { return at_ < text_.size() ? in_quotes(text_.substr(at_)) : "nothing more"; }
  Error error(std::string sentence) const { return {fmt::format("column {}", at_ + 1), std::move(sentence)}; }

  std::string_view text_;
  const Atoms& atoms_;
  std::size_t at_ = 0;
};

Result<Category> Category::parse(std::string_view text, const Atoms& atoms) {
  return CategoryParser(text, atoms).whole();
}

Category Category::function(Category result, Slash slash, Category argument, bool composes) {
  Node node;
  node.size = result.size() + argument.size();
  node.result = std::move(result);
  node.argument = std::move(argument);
  node.slash = slash;
  node.composes = composes;
  return Category(Node::made(std::move(node)));
}

bool Category::is_atom() const { return !node_->result; }
Name Category::name() const {
  require(is_atom(), "name() of a category that is no atom");
  return node_->name;
}
const Category& Category::result() const {
  require(!is_atom(), "result() of an atom");
  return *node_->result;
}
const Category& Category::argument() const {
  require(!is_atom(), "argument() of an atom");
  return *node_->argument;
}
Category::Slash Category::slash() const { return node_->slash; }
bool Category::composes() const { return node_->composes; }
Name Category::target() const { return node_->name; }
std::size_t Category::target_number() const { return node_->number; }
std::size_t Category::size() const { return node_->size; }

bool Category::operator==(const Category& other) const {
  if (node_ == other.node_) return true;
  if (node_->whole != other.node_->whole || is_atom() != other.is_atom()) return false;
  if (is_atom()) return node_->name == other.node_->name && node_->feature == other.node_->feature;
  return slash() == other.slash() && composes() == other.composes() && argument() == other.argument() &&
         result() == other.result();
}

std::string Category::text() const {
  if (is_atom())
    return node_->feature ? fmt::format("{}[{}]", node_->name.text(), node_->feature->text()) : node_->name.text();
  const auto inner = argument().is_atom() ? argument().text() : "(" + argument().text() + ")";
  return fmt::format("{}{}{}{}", result().text(), slash() == Slash::forward ? "/" : "\\", composes() ? "" : "*", inner);
}

bool Agreement::agree(const Category& one, const Category& other) {
  if (one.node_->shape != other.node_->shape || one.is_atom() != other.is_atom()) return false;
  if (!one.is_atom())
    return one.slash() == other.slash() && agree(one.argument(), other.argument()) &&
           agree(one.result(), other.result());
  const auto &a = *one.node_, &b = *other.node_;
  if (a.name != b.name) return false;
  const auto feature = feature_of(one, one_), wanted = feature_of(other, other_);
  if (!a.has_features || (!feature && !wanted)) return true;
  if (feature && wanted) return *feature == *wanted;
  if (feature)
    other_.emplace_back(b.name, *feature);
  else
    one_.emplace_back(a.name, *wanted);
  return true;
}

std::optional<Name> Agreement::feature_of(const Category& atom, const Features& features) {
  if (atom.node_->feature) return atom.node_->feature;
  const auto known =
      std::find_if(features.begin(), features.end(), [&](const auto& each) { return each.first == atom.node_->name; });
  return known == features.end() ? std::nullopt : std::optional(known->second);
}

Category Agreement::settled(const Category& category, const Features& features) {
  if (features.empty()) return category;
  if (category.is_atom()) {
    const auto feature = feature_of(category, features);
    if (feature == category.node_->feature) return category;
    auto node = *category.node_;
    node.feature = feature;
    return Category(Category::Node::made(std::move(node)));
  }
  return Category::function(settled(category.result(), features), category.slash(),
                            settled(category.argument(), features), category.composes());
}

Type type_of(const Category& category, const Atoms& atoms, std::size_t choice) {
  if (!category.is_atom())
    return Type::function(type_of(category.argument(), atoms), type_of(category.result(), atoms, choice));
  const auto& types = atoms.find(category.name().text())->second.types;
  return types[std::min(choice, types.size() - 1)];
}

}  // namespace continua
