#include "replay/commands/machine.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "replay/commands/machine_report.h"
#include "replay/commands/named_machine.h"
#include "replay/exporters/graph_dot.h"
#include "replay/exporters/graph_svg.h"
#include "replay/recorder/recorder.h"

namespace continua {
namespace {

Result<std::string> answer(const MachineOptions& options, const std::shared_ptr<const Machine>& machine) {
  if (!options.dot && !options.svg) return describe(machine);
  const auto graph = state_graph_of(graph_of(*machine), machine->name);
  if (!graph) return graph.error();
  return options.svg ? svg_of(*graph) : dot_of(*graph);
}

}  // namespace

int run_machine(const MachineOptions& options) {
  const auto machine = load_named_machine(options.machine, options.knowledge);
  if (!machine) return report(machine.error()), exit_impossible;
  const auto text = answer(options, *machine);
  if (!text) return report(text.error()), exit_impossible;
  if (const auto problem = write_file(options.output, *text)) return report(*problem), exit_impossible;
  return exit_done;
}

void add_machine_command(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("machine", "Describe a machine, or draw it");
  auto options = std::make_shared<MachineOptions>();
  command->add_option("MACHINE", options->machine, "a name of the knowledge folder, or a path")->required();
  auto* dot = command->add_flag("--dot", options->dot, "its state graph for Graphviz");
  command->add_flag("--svg", options->svg, "its state graph as a picture")->excludes(dot);
  command->add_option("--knowledge", options->knowledge, "folder to use instead of engine/knowledge");
  command->add_option("-o,--output", options->output, "a file, or '-'");
  command->footer("Example: continua machine diana2018 --svg -o diana2018.svg");
  command->callback([options, &run] { run = [options] { return run_machine(*options); }; });
}

}  // namespace continua
