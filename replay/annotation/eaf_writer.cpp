#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "continua/replay/annotation/eaf.h"
#include "continua/replay/media/media_file.h"

namespace continua {
namespace {

constexpr const char* schema = "http://www.mpi.nl/tools/elan/EAFv3.0.xsd";

// A time as xs:dateTime. Where nobody knows it a constant: the same run gives the same bytes.
std::string date_of(const std::string& recorded) {
  constexpr std::string_view unknown = "1970-01-01T00:00:00";
  return recorded + std::string(unknown.substr(std::min(recorded.size(), unknown.size())));
}

// A path as an address: bytes that an address may not have are told by their numbers.
std::string address_of(const std::string& file) {
  std::string address;
  for (const char c : file)
    if (std::isalnum(static_cast<unsigned char>(c)) || std::string_view("/._-~:").find(c) != std::string_view::npos)
      address += c;
    else
      address += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  return address;
}

class EafWriter {
 public:
  explicit EafWriter(const Annotations& annotations) : annotations_(annotations) {}

  std::string write() {
    auto declaration = document_.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    root_ = document_.append_child("ANNOTATION_DOCUMENT");
    root_.append_attribute("AUTHOR") = "continua";
    root_.append_attribute("DATE") = date_of(annotations_.recorded).c_str();
    root_.append_attribute("FORMAT") = "3.0";
    root_.append_attribute("VERSION") = "3.0";
    root_.append_attribute("xmlns:xsi") = "http://www.w3.org/2001/XMLSchema-instance";
    root_.append_attribute("xsi:noNamespaceSchemaLocation") = schema;
    write_header();
    write_times();
    for (const auto& tier : annotations_.tiers) write_tier(tier);
    write_types();
    std::ostringstream out;
    document_.save(out, " ", pugi::format_indent, pugi::encoding_utf8);
    return out.str();
  }

 private:
  void property(pugi::xml_node header, const char* name, const std::string& value) {
    auto element = header.append_child("PROPERTY");
    element.append_attribute("NAME") = name;
    element.text() = label_of(value).c_str();
  }

  void write_header() {
    auto header = root_.append_child("HEADER");
    header.append_attribute("MEDIA_FILE") = "";
    header.append_attribute("TIME_UNITS") = "milliseconds";
    for (const auto& media : annotations_.media) {
      const auto address = address_of(media.file);
      const bool absolute = address.starts_with('/');
      auto element = header.append_child("MEDIA_DESCRIPTOR");
      element.append_attribute("MEDIA_URL") = ((absolute ? "file://" : "./") + address).c_str();
      const auto type = media_type(media.file);
      element.append_attribute("MIME_TYPE") = type.empty() ? "unknown" : type.c_str();
      if (!absolute) element.append_attribute("RELATIVE_MEDIA_URL") = ("./" + address).c_str();
      if (const auto origin = std::llround(media.offset_s * 1000); origin != 0)
        element.append_attribute("TIME_ORIGIN") = static_cast<long long>(origin);
    }
    const auto name = std::filesystem::path(annotations_.name).filename().string();
    property(header, "continua", name);
    if (!annotations_.header.empty()) property(header, "continua.trace", annotations_.header);
    std::size_t last = 0;
    for (const auto& tier : annotations_.tiers)
      for (const auto& annotation : tier.annotations) last = std::max(last, annotation.n);
    property(header, "lastUsedAnnotationId", std::to_string(last));
  }

  // Every annotation has time slots of its own: in ELAN those that share one move together.
  void write_times() {
    std::vector<std::pair<std::int64_t, std::size_t>> times;
    for (const auto& tier : annotations_.tiers)
      for (const auto& annotation : tier.annotations)
        for (const auto time : {annotation.begin_ms, annotation.end_ms}) times.emplace_back(time, times.size());
    std::stable_sort(times.begin(), times.end());
    slots_.resize(times.size());
    auto order = root_.append_child("TIME_ORDER");
    for (std::size_t i = 0; i < times.size(); ++i) {
      slots_[times[i].second] = fmt::format("ts{}", i + 1);
      auto slot = order.append_child("TIME_SLOT");
      slot.append_attribute("TIME_SLOT_ID") = slots_[times[i].second].c_str();
      slot.append_attribute("TIME_VALUE") = static_cast<long long>(times[i].first);
    }
  }

  std::string fresh_id(std::size_t n) {
    const int times = ++ids_[n];
    return times == 1 ? fmt::format("a{}", n) : fmt::format("a{}-{}", n, times);
  }

  pugi::xml_node tier_element(const Tier& tier, const std::string& name, const char* type) {
    auto element = root_.append_child("TIER");
    element.append_attribute("LINGUISTIC_TYPE_REF") = type;
    if (!tier.participant.empty()) element.append_attribute("PARTICIPANT") = tier.participant.c_str();
    element.append_attribute("TIER_ID") = name.c_str();
    return element;
  }

  void write_tier(const Tier& tier) {
    auto element = tier_element(tier, tier.name, "continua");
    std::vector<std::string> ids;
    for (const auto& annotation : tier.annotations) {
      ids.push_back(fresh_id(annotation.n));
      auto aligned = element.append_child("ANNOTATION").append_child("ALIGNABLE_ANNOTATION");
      aligned.append_attribute("ANNOTATION_ID") = ids.back().c_str();
      aligned.append_attribute("TIME_SLOT_REF1") = slots_[next_slot_++].c_str();
      aligned.append_attribute("TIME_SLOT_REF2") = slots_[next_slot_++].c_str();
      aligned.append_child("ANNOTATION_VALUE").text() = annotation.value.c_str();
    }
    if (std::all_of(tier.annotations.begin(), tier.annotations.end(), [](const auto& a) { return a.event.is_null(); }))
      return;
    element = tier_element(tier, tier.name + events_ending, "continua event");
    element.append_attribute("PARENT_REF") = tier.name.c_str();
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (tier.annotations[i].event.is_null()) continue;
      auto reference = element.append_child("ANNOTATION").append_child("REF_ANNOTATION");
      reference.append_attribute("ANNOTATION_ID") = ("e" + ids[i].substr(1)).c_str();
      reference.append_attribute("ANNOTATION_REF") = ids[i].c_str();
      reference.append_child("ANNOTATION_VALUE").text() = compact(tier.annotations[i].event).c_str();
    }
  }

  void write_types() {
    const auto type = [&](const char* id, bool alignable) {
      auto element = root_.append_child("LINGUISTIC_TYPE");
      if (!alignable) element.append_attribute("CONSTRAINTS") = "Symbolic_Association";
      element.append_attribute("GRAPHIC_REFERENCES") = false;
      element.append_attribute("LINGUISTIC_TYPE_ID") = id;
      element.append_attribute("TIME_ALIGNABLE") = alignable;
    };
    type("continua", true);
    type("continua event", false);
    auto constraint = root_.append_child("CONSTRAINT");
    constraint.append_attribute("DESCRIPTION") = "1-1 association with a parent annotation";
    constraint.append_attribute("STEREOTYPE") = "Symbolic_Association";
  }

  const Annotations& annotations_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  std::vector<std::string> slots_;  // of the beginning and the end of each annotation
  std::size_t next_slot_ = 0;
  std::map<std::size_t, int> ids_;
};

}  // namespace

std::string eaf_of(const Annotations& annotations) { return EafWriter(annotations).write(); }

}  // namespace continua
