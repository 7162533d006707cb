#include "continua/replay/export/graph_layout.h"

#include <fmt/format.h>
#include <graphviz/gvc.h>
#include <algorithm>
#include <cstdlib>
#include <deque>
#include <string>

extern "C" gvplugin_library_t gvplugin_dot_layout_LTX_library;

namespace continua {
namespace {

constexpr double points_per_inch = 72;

// Graphviz's effort grows with the number of ranks that all edges together pass: up to a second for 1,500 in full
// quality, up to half a minute for 100,000 with straight lines and few attempts to make them cross less.
constexpr long most_in_full_quality = 1500;
constexpr const char* draft = " nslimit=2 nslimit1=2 mclimit=0.1 splines=line";

std::string graphviz_message;

extern "C" int keep_message(char* message) {
  graphviz_message += message;
  return 0;
}

// The edges to be laid the other way round, so that no cycle is left: those that lead back to a node nearer to `first`,
// and all that lead to `first`. Where Graphviz has to turn edges itself, it loses memory.
std::vector<bool> turned_edges(std::size_t node_count, const std::vector<LayoutEdge>& edges, std::size_t first) {
  std::vector<std::vector<std::size_t>> followers(node_count);
  for (const auto& edge : edges) followers[edge.from].push_back(edge.to);
  std::vector<std::size_t> rank(node_count, 0);  // its place in a search in breadth from 1; what `first` does not
  std::size_t next = node_count;                 // lead to comes before all that it leads to
  const auto search = [&](std::size_t root) {
    std::deque<std::size_t> waiting;
    const auto reach = [&](std::size_t node) {
      if (rank[node] != 0) return;
      rank[node] = ++next;
      waiting.push_back(node);
    };
    for (reach(root); !waiting.empty(); waiting.pop_front())
      for (const auto node : followers[waiting.front()]) reach(node);
  };
  search(first);
  next = 0;
  for (std::size_t i = 0; i < node_count; ++i) search(i);
  std::vector<bool> turned;
  for (const auto& edge : edges) turned.push_back(edge.to == first || rank[edge.to] < rank[edge.from]);
  return turned;
}

// A label is a cell without text, since Graphviz would measure text with any fonts there are.
std::string document_of(const std::vector<LayoutNode>& nodes, const std::vector<LayoutEdge>& edges,
                        const LayoutStyle& style, const char* effort) {
  auto text = fmt::format(
      "digraph {{ rankdir={} nodesep={:.4f} ranksep={:.4f} node [shape=box fixedsize=true label=\"\"]"
      " edge [arrowhead=none headclip=false tailclip=false]\n",
      style.downward ? "TB" : "LR", style.between_nodes / points_per_inch, style.between_ranks / points_per_inch);
  text += fmt::format("graph [{}]\n", effort);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    text += fmt::format("{} [width={:.4f} height={:.4f}]\n", i, nodes[i].width / points_per_inch,
                        nodes[i].height / points_per_inch);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& edge = edges[i];
    text += fmt::format("{} -> {} [key={}", edge.from, edge.to, i);
    if (edge.label_width > 0)
      text += fmt::format(
          R"( label=<<TABLE BORDER="0" CELLBORDER="0" CELLSPACING="0"><TR><TD FIXEDSIZE="TRUE" WIDTH="{:.0f}" HEIGHT="{:.0f}"></TD></TR></TABLE>>)",
          edge.label_width, edge.label_height);
    text += "]\n";
  }
  return text + "}\n";
}

// Takes over the results of Graphviz, whose y goes up.
Layout layout_of(Agraph_t* graph, std::size_t node_count, const std::vector<LayoutEdge>& edges) {
  const auto point = [](const pointf& p) { return PagePoint{p.x, -p.y}; };
  Layout layout;
  std::vector<Agnode_t*> found;
  for (std::size_t i = 0; i < node_count; ++i) {
    auto name = std::to_string(i);
    found.push_back(agnode(graph, name.data(), 0));
    layout.nodes.push_back(point(ND_coord(found.back())));
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    auto key = std::to_string(i);
    auto* edge = agedge(graph, found[edges[i].from], found[edges[i].to], key.data(), 0);
    PlacedEdge placed;
    if (const auto* curves = ED_spl(edge); curves && curves->size > 0)
      for (int k = 0; k < curves->list[0].size; ++k) placed.curve.push_back(point(curves->list[0].list[k]));
    if (const auto* label = ED_label(edge)) placed.label = point(label->pos);
    layout.edges.push_back(std::move(placed));
  }
  return layout;
}

// One layout of a document; everything of it is given back at the end.
class Work {
 public:
  explicit Work(const std::string& document) : graph_(agmemread(document.c_str())) {
    static lt_symlist_t plugins[] = {{"gvplugin_dot_layout_LTX_library", &gvplugin_dot_layout_LTX_library},
                                     {nullptr, nullptr}};
    context_ = gvContextPlugins(plugins, 0);
    done_ = context_ && graph_ && gvLayout(context_, graph_, "dot") == 0;
  }
  ~Work() {
    if (done_) gvFreeLayout(context_, graph_);
    if (graph_) agclose(graph_);
    if (context_) gvFreeContext(context_);
  }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  Agraph_t* graph() const { return done_ ? graph_ : nullptr; }

 private:
  Agraph_t* graph_;
  GVC_t* context_;
  bool done_ = false;
};

// How many ranks all edges together pass, of a layout that ended after ranking.
long ranks_passed(Agraph_t* graph) {
  char key[] = "rank";
  long sum = 0;
  for (auto* node = agfstnode(graph); node; node = agnxtnode(graph, node))
    for (auto* edge = agfstout(graph, node); edge; edge = agnxtout(graph, edge))
      sum += std::abs(std::atol(agget(aghead(edge), key)) - std::atol(agget(agtail(edge), key)));
  return sum;
}

}  // namespace

Result<Layout> lay_out(const std::vector<LayoutNode>& nodes, const std::vector<LayoutEdge>& given, std::size_t first,
                       const LayoutStyle& style) {
  auto edges = given;
  const auto turned = turned_edges(nodes.size(), edges, first);
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (turned[i]) std::swap(edges[i].from, edges[i].to);
  graphviz_message.clear();
  agseterrf(keep_message);
  const Work ranking(document_of(nodes, edges, style, " phase=1 nslimit1=2"));
  if (!ranking.graph()) return Error{"", "Graphviz could not rank its states: " + graphviz_message};
  const auto effort = ranks_passed(ranking.graph());
  const Work work(document_of(nodes, edges, style, effort > most_in_full_quality ? draft : ""));
  if (!work.graph()) return Error{"", "Graphviz could not lay it out: " + graphviz_message};
  auto layout = layout_of(work.graph(), nodes.size(), edges);
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (turned[i]) std::reverse(layout.edges[i].curve.begin(), layout.edges[i].curve.end());
  return layout;
}

}  // namespace continua
