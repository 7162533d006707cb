// continua explain: why a run went as it did.
#pragma once

#include <string>

#include "continua/replay/commands/command.h"
#include "continua/replay/explain/explain.h"

namespace continua {

struct ExplainOptions {
  std::string run;
  ExplainQuestion question;
  bool json = false, tree = false, all = false;
};

int run_explain(const ExplainOptions& options);

void describe_explain(CLI::App& command, ExplainOptions& options);

}  // namespace continua
