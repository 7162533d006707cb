#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <utility>

#include "continua/core/located_json.h"
#include "continua/core/trimmed.h"
#include "continua/voxml/catalogue.h"
#include "continua/voxml/catalogue_text.h"

namespace continua {
namespace {

constexpr int deepest_element = 100;

std::string_view without_prefix(std::string_view name) { return name.substr(name.find(':') + 1); }

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return (x | 0x20) == (y | 0x20); });
}

// The items between commas.
std::vector<std::string> items(std::string_view text) {
  std::vector<std::string> items;
  while (!text.empty()) {
    const auto comma = std::min(text.find(','), text.size());
    if (const auto item = trimmed(text.substr(0, comma)); !item.empty()) items.emplace_back(item);
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return items;
}

// cylindroid[1], leg[2]+
Numbered numbered(std::string_view text) {
  const auto open = text.find('['), close = text.find(']', open);
  if (open == text.npos || close == text.npos) return {std::string(text), ""};
  return {std::string(trimmed(text.substr(0, open))).append(trimmed(text.substr(close + 1))),
          std::string(trimmed(text.substr(open + 1, close - open - 1)))};
}

class DocumentReader {
 public:
  DocumentReader(std::string text, std::string path) : text_(std::move(text)), path_(std::move(path)) {}

  Result<ReadVoxeme> read() {
    const auto parsed = document_.load_buffer(text_.data(), text_.size(), pugi::parse_default, pugi::encoding_utf8);
    for (std::size_t at = 0; at < text_.size(); ++at)
      if (text_[at] == '\n') line_ends_.push_back(at);
    if (!parsed) return error(parsed.offset, fmt::format("not valid XML: {}", parsed.description()));
    const auto root = document_.document_element();
    if (!same_letters(without_prefix(root.name()), "VoxML"))
      return error(root.offset_debug(), fmt::format("found the root <{}>, expected <VoxML>", root.name()));
    voxeme().path = path_;
    for (const auto attribute : root.attributes()) unknown_attribute(root, attribute, "");
    for (const auto child : root.children())
      if (!element(child, "", 1))
        return error(child.offset_debug(), fmt::format("elements more than {} deep", deepest_element));
    if (entity_.empty())
      return error(root.offset_debug(), "there is no Entity, expected <Entity Type=\"Object\" /> or another type");
    if (!set_entity())
      return error(entity_at_,
                   fmt::format("found the entity {}, expected Object, Program, Attribute, Relation or Function",
                               in_quotes(entity_)));
    if (voxeme().predicate.empty()) name_by_file(root);
    return std::move(read_);
  }

 private:
  using Take = void (DocumentReader::*)(const pugi::xml_node&, const std::string& value);

  Voxeme& voxeme() { return read_.voxeme; }

  std::string place(std::ptrdiff_t offset) const {
    const auto line = std::lower_bound(line_ends_.begin(), line_ends_.end(),
                                       static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)));
    return fmt::format("{}:{}", path_, line - line_ends_.begin() + 1);
  }
  Error error(std::ptrdiff_t offset, std::string sentence) const { return {place(offset), std::move(sentence)}; }
  void note(const pugi::xml_node& at, std::string sentence) {
    read_.notes.push_back({place(at.offset_debug()), std::move(sentence)});
  }

  // Some documents are published with an empty <Pred>, under the name of their voxeme.
  void name_by_file(const pugi::xml_node& root) {
    voxeme().predicate = std::filesystem::path(path_).stem().string();
    note(root, fmt::format("there is no predicate in <Lex><Pred>; the file's name is taken: {}",
                           in_quotes(voxeme().predicate)));
  }

  void keep(const std::string& path, const std::string& value) {
    auto& kept = voxeme().others[path];
    kept += (kept.empty() ? "" : "; ") + value;
  }

  bool set_entity() {
    for (const auto entity : {Voxeme::Entity::object, Voxeme::Entity::program, Voxeme::Entity::attribute,
                              Voxeme::Entity::relation, Voxeme::Entity::function})
      if (same_letters(entity_, name_of(entity))) {
        voxeme().entity = entity;
        return true;
      }
    return false;
  }

  // Whether the attribute declares a namespace or a schema.
  static bool is_of_xml(std::string_view attribute) {
    return attribute == "xmlns" || attribute.starts_with("xmlns:") || attribute.starts_with("xsi:") ||
           attribute.starts_with("xml:");
  }

  void unknown_attribute(const pugi::xml_node& node, const pugi::xml_attribute& attribute, const std::string& path) {
    if (is_of_xml(attribute.name())) return;
    note(node, fmt::format("the attribute {} of <{}> is unknown", attribute.name(), node.name()));
    keep(path + (path.empty() ? "" : "/") + attribute.name(), std::string(trimmed(attribute.value())));
  }

  // The value of an element: the attribute for it, else its text.
  std::string value_of(const pugi::xml_node& node, std::string_view attribute_name) const {
    for (const auto attribute : node.attributes())
      if (same_letters(without_prefix(attribute.name()), attribute_name) && !is_of_xml(attribute.name()))
        return std::string(trimmed(attribute.value()));
    std::string text;
    for (const auto child : node.children())
      if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) text += child.value();
    return std::string(trimmed(text));
  }

  bool element(const pugi::xml_node& node, const std::string& parent, int depth) {
    if (node.type() != pugi::node_element) return true;
    if (depth > deepest_element) return false;
    const auto path = parent + (parent.empty() ? "" : "/") + std::string(without_prefix(node.name()));
    const auto& known = kinds();
    const auto kind = known.find(path);
    const std::string_view attribute = kind == known.end() ? "Value" : kind->second.attribute;
    for (const auto each : node.attributes())
      if (!same_letters(without_prefix(each.name()), attribute) &&
          !(kind != known.end() && is_clause(kind->second, each)))
        unknown_attribute(node, each, path);
    const auto value = value_of(node, attribute);
    if (kind == known.end()) {
      if (!is_group(path)) note(node, fmt::format("the element <{}> is unknown", path));
      if (!value.empty()) keep(path, value);
    } else if (!value.empty() || is_clause(kind->second)) {
      if (kind->second.take)
        (this->*kind->second.take)(node, value);
      else
        keep(path, value);
    }
    for (const auto child : node.children())
      if (!element(child, path, depth + 1)) return false;
    return true;
  }

  struct Kind {
    const char* attribute;  // the attribute with the value of such an element
    Take take;              // nullptr: the value is kept as text
  };

  static bool is_clause(const Kind& kind) { return std::string_view(kind.attribute) == "Name"; }
  static bool is_clause(const Kind& kind, const pugi::xml_attribute& attribute) {
    const std::string_view name = without_prefix(attribute.name());
    if (std::string_view(kind.attribute) == "Least") return same_letters(name, "PerMetre");
    return is_clause(kind) && same_letters(name, "Value");
  }

  // Elements that only contain others.
  static bool is_group(const std::string& path) {
    constexpr std::array<std::string_view, 12> groups = {
        "Lex",        "Type",       "Type/Components",   "Type/Args",         "Type/Body",
        "Habitat",    "Afford_Str", "Habitat/Intrinsic", "Habitat/Extrinsic", "Afford_Str/Affordances",
        "Embodiment", "Attributes"};
    return path == "Attributes/Attrs" || path == "Type/Corresps" ||
           std::find(groups.begin(), groups.end(), path) != groups.end();
  }

  static const std::map<std::string, Kind>& kinds() {
    using R = DocumentReader;
    static const std::map<std::string, Kind> kinds = {
        {"Entity", {"Type", &R::entity}},
        {"Lex/Pred", {"Value", &R::text<&Voxeme::predicate>}},
        {"Lex/Type", {"Value", &R::text<&Voxeme::lex_type>}},
        {"Type/Head", {"Value", &R::number<&Voxeme::head>}},
        {"Type/Components/Component", {"Value", &R::component}},
        {"Type/Concavity", {"Value", &R::number<&Voxeme::concavity>}},
        {"Type/RotatSym", {"Value", &R::list<&Voxeme::rotational_symmetry>}},
        {"Type/ReflSym", {"Value", &R::list<&Voxeme::reflectional_symmetry>}},
        {"Type/Args/Arg", {"Value", &R::argument}},
        {"Type/Body/Subevent", {"Value", &R::subevent}},
        {"Type/Goal", {"Value", &R::text<&Voxeme::goal>}},
        {"Type/Spread", {"Least", &R::spread}},
        {"Type/Scale", {"Value", nullptr}},
        {"Type/Arity", {"Value", nullptr}},
        {"Type/Class", {"Value", nullptr}},
        {"Type/Value", {"Value", nullptr}},
        {"Type/Constr", {"Value", nullptr}},
        {"Type/Referent", {"Value", nullptr}},
        {"Type/Mapping", {"Value", nullptr}},
        {"Type/Corresps/Corresp", {"Value", nullptr}},
        {"Habitat/Intrinsic/Intr", {"Name", &R::clause<&Voxeme::intrinsic>}},
        {"Habitat/Extrinsic/Extr", {"Name", &R::clause<&Voxeme::extrinsic>}},
        {"Afford_Str/Affordances/Affordance", {"Formula", &R::affordance}},
        {"Embodiment/Scale", {"Value", &R::text<&Voxeme::scale>}},
        {"Embodiment/Movable", {"Value", &R::movable}},
        {"Attributes/Attrs/Attr", {"Value", &R::attribute}},
    };
    return kinds;
  }

  void entity(const pugi::xml_node& node, const std::string& value) {
    entity_ = value;
    entity_at_ = node.offset_debug();
  }
  template <std::string Voxeme::*member>
  void text(const pugi::xml_node& node, const std::string& value) {
    auto& target = voxeme().*member;
    if (!target.empty() && target != value) note(node, fmt::format("a second <{}>; the last one counts", node.name()));
    target = value;
  }
  template <auto member>
  void number(const pugi::xml_node&, const std::string& value) {
    voxeme().*member = numbered(value);
  }
  template <auto member>
  void list(const pugi::xml_node&, const std::string& value) {
    voxeme().*member = items(value);
  }
  void component(const pugi::xml_node&, const std::string& value) { voxeme().components.push_back(numbered(value)); }
  void attribute(const pugi::xml_node&, const std::string& value) { voxeme().attributes.push_back(value); }

  void argument(const pugi::xml_node&, const std::string& text) {
    const std::string_view value = text;
    const auto colon = std::min(value.find(':'), value.size());
    voxeme().arguments.push_back({std::string(trimmed(value.substr(0, colon))),
                                  std::string(trimmed(value.substr(std::min(colon + 1, value.size()))))});
  }

  void movable(const pugi::xml_node& node, const std::string& value) {
    voxeme().movable = same_letters(value, "true") || value == "1";
    if (!voxeme().movable && !same_letters(value, "false") && value != "0")
      note(node, fmt::format("found {}, expected true or false", in_quotes(value)));
  }

  template <std::vector<HabitatClause> Voxeme::*member>
  void clause(const pugi::xml_node& node, const std::string& name) {
    HabitatClause clause{numbered(name), value_of(node, "Value")};
    if (!name.empty() || !clause.value.empty()) (voxeme().*member).push_back(std::move(clause));
  }

  // A number of metres, at least 0; nothing if it is none.
  std::optional<double> metres(const pugi::xml_node& node, const std::string& value) {
    double read = 0;
    const auto [end, problem] = std::from_chars(value.data(), value.data() + value.size(), read);
    if (problem == std::errc() && end == value.data() + value.size() && read >= 0 && std::isfinite(read)) return read;
    note(node, fmt::format("found {}, expected metres, such as 0.024", in_quotes(value)));
    return std::nullopt;
  }
  void spread(const pugi::xml_node& node, const std::string& value) {
    const auto least = metres(node, value);
    const auto more = value_of(node, "PerMetre");
    const auto per_metre = more.empty() ? std::optional(0.0) : metres(node, more);
    if (least && per_metre) voxeme().spread = VoxemeSpread{*least, *per_metre};
  }

  void unread(const pugi::xml_node& node, const std::string& path, const std::string& value, const Error& problem) {
    note(node, fmt::format("{} cannot be read: {}", in_quotes(value), problem.text()));
    keep(path, value);
  }
  void subevent(const pugi::xml_node& node, const std::string& value) {
    auto steps = parse_subevents(value);
    if (!steps) return unread(node, "Type/Body/Subevent", value, steps.error());
    std::move(steps->begin(), steps->end(), std::back_inserter(voxeme().body));
  }
  void affordance(const pugi::xml_node& node, const std::string& value) {
    auto formula = parse_affordance(value);
    if (!formula) return unread(node, "Afford_Str/Affordances/Affordance", value, formula.error());
    voxeme().affordances.push_back(*std::move(formula));
  }

  std::string text_, path_;
  pugi::xml_document document_;
  std::vector<std::size_t> line_ends_;
  std::string entity_;
  std::ptrdiff_t entity_at_ = 0;
  ReadVoxeme read_;
};

}  // namespace

Result<ReadVoxeme> read_voxeme(std::string_view text, const std::string& path) {
  auto utf8 = utf8_of_xml(text, path);
  if (!utf8) return utf8.error();
  return DocumentReader(*std::move(utf8), path).read();
}

bool looks_like_voxeme(std::string_view text) {
  const auto utf8 = utf8_of_xml(text, "");
  if (!utf8) return text.find("<VoxML") != text.npos;
  std::string_view rest = *utf8;
  // Past declarations, instructions and comments to the first element.
  for (;;) {
    const auto open = rest.find('<');
    if (open == rest.npos) return false;
    rest.remove_prefix(open);
    const bool comment = rest.starts_with("<!--");
    if (!comment && !rest.starts_with("<?") && !rest.starts_with("<!")) break;
    const std::string_view close = comment ? "-->" : rest.starts_with("<?") ? "?>" : ">";
    const auto end = rest.find(close);
    if (end == rest.npos) return false;
    rest.remove_prefix(end + close.size());
  }
  const auto name = rest.substr(1, std::min(rest.find_first_of(" \t\r\n/>", 1), rest.size()) - 1);
  return same_letters(without_prefix(name), "VoxML");
}

}  // namespace continua
