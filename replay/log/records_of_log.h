// Records of a run log about the run itself: the header, problems, blocks and the end.
#pragma once

#include <fmt/format.h>

#include "continua/replay/log/brief_words.h"
#include "continua/replay/log/fields.h"

namespace continua::log {

/// A file by its name and the digest of its bytes.
struct NamedFile {
  std::string name;
  OrNull<std::string> digest;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("name", &NamedFile::name, Says::how, "Name of the file.");
    use("digest", &NamedFile::digest, Says::how,
        "Digest of its bytes; null for a trace that was written along with the run.");
  }
};

/// A file with all that it says.
struct Document {
  std::string name, digest;
  JsonText document;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("name", &Document::name, Says::how, "Name of the file.");
    use("digest", &Document::digest, Says::how, "Digest of its bytes.");
    use("document", &Document::document, Says::how, "The whole file.");
  }
};

struct VoxemeFiles {
  std::string digest;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("digest", &VoxemeFiles::digest, Says::how, "Digest of all voxemes.");
  }
};

/// Where the run was made; floating-point results may differ elsewhere.
struct Fingerprint {
  std::string mujoco, compiler, arch, instructions;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("mujoco", &Fingerprint::mujoco, Says::how, "Version of MuJoCo.");
    use("compiler", &Fingerprint::compiler, Says::how, "Name and version of the compiler.");
    use("arch", &Fingerprint::arch, Says::how, "The processor's architecture.");
    use("instructions", &Fingerprint::instructions, Says::how, "Its instruction sets.");
  }
};

/// The condition of a state, and where the automaton goes if it does not hold.
struct GraphGate {
  std::string condition, otherwise, operation;
  JsonText content;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("condition", &GraphGate::condition, Says::how, "The condition.", {.form = "term"});
    use("else", &GraphGate::otherwise, Says::how, "The state to go to where it does not hold.");
    use("operation", &GraphGate::operation, Says::how, "Name of the operation on the way there.");
    use("content", &GraphGate::content, Says::how, "Its content in the machine file, or null.");
  }
};

struct GraphState {
  std::string id;
  bool accepting = false;
  std::optional<GraphGate> gate;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("id", &GraphState::id, Says::how, "Name of the state.");
    use("accepting", &GraphState::accepting, Says::how, "Whether it accepts.");
    use("gate", &GraphState::gate, Says::how, "Its entry condition; left out where it has none.");
  }
};

struct GraphEdge {
  std::string id, from, to, input;
  OrNull<std::string> condition;
  double weight = 0;
  std::string operation;
  JsonText content;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("id", &GraphEdge::id, Says::how, "Id of the transition.");
    use("from", &GraphEdge::from, Says::how, "The state that it leaves.");
    use("to", &GraphEdge::to, Says::how, "The state that it leads to.");
    use("input", &GraphEdge::input, Says::how, "Label of the inputs that it takes, or `ε`.");
    use("condition", &GraphEdge::condition, Says::how, "Its condition, or null.", {.form = "term"});
    use("weight", &GraphEdge::weight, Says::how, "Its weight.");
    use("operation", &GraphEdge::operation, Says::how, "Name of its operation.");
    use("content", &GraphEdge::content, Says::how, "The operation's content in the machine file, or null.");
  }
};

/// The machine as a graph. A transition from several states gives one edge for each.
struct Graph {
  std::vector<GraphState> states;
  std::string start;
  std::vector<GraphEdge> edges;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("states", &Graph::states, Says::how, "The states, in the order of the machine file.");
    use("start", &Graph::start, Says::how, "Name of the first state.");
    use("edges", &Graph::edges, Says::how, "The transitions; one from several states is several.");
  }
};

/// The world when the run begins.
struct SceneDescription {
  std::string name, digest, mjcf;
  Json geoms, bodies;
  std::optional<std::vector<std::string>> without_voxeme;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("name", &SceneDescription::name, Says::how, "Name of the scene.");
    use("digest", &SceneDescription::digest, Says::how, "Digest of its file.");
    use("mjcf", &SceneDescription::mjcf, Says::how, "The file.");
    use("geoms", &SceneDescription::geoms, Says::how,
        "[{`body`, `type`, `size`, `rgba`, `pos`, `quat`}] as MuJoCo has them, poses in the body's frame, metres; "
        "of type `mesh` also `mesh` {`vertices` [x, y, z, …], `faces` [a, b, c, …: numbers of vertices]} unless "
        "it is very large.");
    use("bodies", &SceneDescription::bodies, Says::how, "{body: [x, y, z, qw, qx, qy, qz]} in frame W, metres.");
    use("without_voxeme", &SceneDescription::without_voxeme, Says::how,
        "Objects that have no voxeme; left out where each has one.");
  }
};

struct Run {
  std::int64_t version = 1;
  std::string continua;
  NamedFile trace;
  std::uint64_t seed = 0;
  std::string choice;
  Named<std::string> forced;
  OrNull<std::int64_t> most_branches;
  std::string world, perspective;
  Fingerprint fingerprint;
  Document machine;
  OrNull<Document> phrases;
  OrNull<NamedFile> lexicon;
  OrNull<VoxemeFiles> voxemes;
  Json knowledge, learned;
  Graph graph;
  SceneDescription scene;
  std::optional<Json> parameters;
  std::optional<std::string> variant;
  std::optional<Json> what_if;

  static constexpr Kind kind{.name = "run", .when = "The first line.", .stop = Stop::never, .brief_adds = "on"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("version", &Run::version, Says::how, "1: the version of this format.");
    use("continua", &Run::continua, Says::how, "Version of the program.");
    use("trace", &Run::trace, Says::how, "The trace.", {.in_brief = true});
    use("seed", &Run::seed, Says::how, "The seed of random choices.");
    use("choice", &Run::choice, Says::how, "How one of several transitions is chosen.");
    use("forced", &Run::forced, Says::how, "{step: id of the transition that is forced there}.");
    use("most_branches", &Run::most_branches, Says::how, "Bound on the branches under `explore`; else null.");
    use("world", &Run::world, Says::how, "`physics` or `kinematic`.");
    use("perspective", &Run::perspective, Says::how, "Whose left and right words go by.");
    use("fingerprint", &Run::fingerprint, Says::how, "The build and the processor.");
    use("machine", &Run::machine, Says::how, "The machine file.", {.in_brief = true});
    use("phrases", &Run::phrases, Says::how, "The machine's phrases, or null.");
    use("lexicon", &Run::lexicon, Says::how, "The machine's lexicon, or null.");
    use("voxemes", &Run::voxemes, Says::how, "The voxemes, or null.");
    use("knowledge", &Run::knowledge, Says::how,
        "{file: digest} of all files that words, gestures and voxemes come from.");
    use("learned", &Run::learned, Says::how,
        "What was taught before the run, as the file of `--learned` has it, or null.");
    use("graph", &Run::graph, Says::how, "The machine as a graph.");
    use("scene", &Run::scene, Says::how, "The world when the run begins.");
    use("parameters", &Run::parameters, Says::how,
        "{name: value} of all parameters of the machine, and of its numbers that were set for this run; left out "
        "where there are none.");
    use("variant", &Run::variant, Says::how,
        "`world` or `teacher`: how far the run follows the observations; left out where it does not.");
    use("what_if", &Run::what_if, Says::how,
        "The changes in mid-run, as RUNLOG.md describes; left out where there were none.");
  }
  std::string brief() const { return joined({trace.name, "on", machine.name}); }
};

struct Problem {
  OrNull<std::int64_t> line;
  std::string message;

  static constexpr Kind kind{
      .name = "problem",
      .when = "Something in the trace could not be used, or something in the machine could not be carried out.",
      .brief_adds = "line :"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("line", &Problem::line, Says::where, "Line of the trace, or null.", {.in_brief = true});
    use("message", &Problem::message, Says::aside, "The problem, a sentence.", {.in_brief = true});
  }
  std::string brief() const { return fmt::format("line {}: {}", line ? std::to_string(*line) : "", message); }
};

struct Block {
  std::array<std::int64_t, 2> records{};
  std::string digest;

  static constexpr Kind kind{
      .name = "block", .when = "Every 256th line.", .stop = Stop::never, .brief_adds = "[,] records to"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("records", &Block::records, Says::where, "[first, last] of the lines since the block before.",
        {.in_brief = true});
    use("digest", &Block::digest, Says::aside,
        "Digest of the digest of the block before (nothing for the first), its line and these lines: a chain.");
  }
  std::string brief() const { return fmt::format("records {} to {}", records[0], records[1]); }
};

/// A decision that was near to another one.
struct FragileDecision {
  std::int64_t n = 0;
  double margin = 0;

  template <class Use>
  static constexpr void fields(Use&& use) {
    use("n", &FragileDecision::n, Says::where, "Number of the record.", {.form = "record"});
    use("margin", &FragileDecision::margin, Says::aside, "Its smallest margin.");
  }
};

struct End {
  Named<std::int64_t> counts;
  std::vector<FragileDecision> fragile;
  std::string decisions, physics, digest;

  static constexpr Kind kind{
      .name = "end", .when = "The last line.", .stop = Stop::never, .brief_adds = "end of the log"};
  template <class Use>
  static constexpr void fields(Use&& use) {
    use("counts", &End::counts, Says::aside, "{kind: number of its records}.");
    use("fragile", &End::fragile, Says::aside,
        "The decisions that the smallest step decisions see, 0.1 mm, could have changed.");
    use("decisions", &End::decisions, Says::aside, "Digest of all that must be equal on every machine.");
    use("physics", &End::physics, Says::aside, "Digest of the poses.");
    use("digest", &End::digest, Says::aside, "Digest of all lines before.");
  }
  std::string brief() const { return "end of the log"; }
};

using RecordsOfLog = Kinds<Run, Problem, Block, End>;

}  // namespace continua::log
