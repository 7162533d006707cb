#include "language/reference.h"

#include "support/small_talk.h"

namespace continua {
namespace {
}  // namespace

TEST_CASE("tmp") {
  SmallTalk talk;
  talk.world.objects = {thing("a","block","red",{.06,.06,.06},0,0), thing("p","plate","",{.1,.1,.02},.2,0)};
  for (auto* text: {"the(\\x. block(x) and located(x, left(p)))","the(\\x. block(x) and located(x, left(the(\\y. plate(y)))))", "the(\\y. plate(y))"}) {
  auto r = talk.refer(text);
  for (auto& e : r.ruled_out) WARN(e.object << " " << e.reason);
  WARN(names_of(r));}
}

}  // namespace continua
