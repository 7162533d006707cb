// continua explain: why a run went as it did.
#pragma once

#include <string>

#include "replay/commands/command.h"
#include "replay/explain/explain.h"

namespace continua {

struct ExplainOptions {
  std::string run;
  ExplainQuestion question;
  bool json = false, tree = false, all = false;
};

int run_explain(const ExplainOptions& options);

void add_explain_command(CLI::App& program, Run& run);

}  // namespace continua
