// What the moves of another avatar tell of where the dialogue is.
#include "machine_file/machine_reader.h"

namespace continua {

void MachineReader::read_implied(const Item& implied) {
  if (!expect_array(implied, "what observed moves imply")) return;
  for (std::size_t i = 0; i < implied.json->size(); ++i) {
    const auto item = element(implied, i);
    if (!expect_object(item, "what is implied")) continue;
    Implied row;
    row.number = i + 1;
    if (const auto when = member(item, "when"); when.json) row.when = parse(when, Type::truth());
    row.to = state_named(required(item, "to", "the state that the dialogue is in then"));
    if (const auto stack = member(item, "stack"); expect_array(stack, "operations, one after the other"))
      for (std::size_t k = 0; k < stack.json->size(); ++k) {
        const auto operation = element(stack, k);
        if (expect_object(operation, "an operation")) row.operations.push_back(read_operation(operation));
      }
    machine_.implied.push_back(std::move(row));
  }
}

}  // namespace continua
