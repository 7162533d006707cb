// Sentences and their readings, beside the examples of the lexicon itself.
#include "language/parser.h"

#include "core/random.h"
#include "language/english.h"
#include "support/catch.h"

using namespace continua;

namespace {

struct Row {
  const char* text;
  const char* reading;
};

// Written before they were read for the first time.
const Row sentences[] = {
    {"grab the purple mug", R"(grasp(the(\x. purple(x) and cup(x))))"},
    {"set the fork beside the plate", R"(put(the(\x. fork(x)), beside(the(\x. plate(x)))))"},
    {"would you put that spoon inside the white bowl", R"(put(that(\x. spoon(x)), in(the(\x. white(x) and bowl(x)))))"},
    {"lift up both bottles", R"(lift(both(\x. bottle(x))))"},
    {"drag the bowl over here", R"(slide(the(\x. bowl(x)), here))"},
    {"place it between the fork and the spoon", R"(put(it, between(the(\x. fork(x)), the(\x. spoon(x)))))"},
    {"release the knife", R"(ungrasp(the(\x. knife(x))))"},
    {"let go of the yellow ball", R"(ungrasp(the(\x. yellow(x) and ball(x))))"},
    {"nope, the pink one", R"(no; the(\x. pink(x) and one(x)))"},
    {"yeah that one", R"(yes; that(\x. one(x)))"},
    {"under the bowl", R"(under(the(\x. bowl(x))))"},
    {"to the right of that cup", R"(right(that(\x. cup(x))))"},
    {"the ball touching the bottle", R"(the(\x. ball(x) and located(x, touching(the(\y. bottle(y))))))"},
    {"the black block near me", R"(the(\x. black(x) and block(x) and located(x, near(me))))"},
    {"put the book at that spot", R"(put(the(\x. book(x)), there))"},
    {"put down the yellow bottle please", R"(ungrasp(the(\x. yellow(x) and bottle(x))))"},
    {"nudge it backward", R"(slide(it, in_front(it)))"},
    {"shove the brown box to the left", R"(slide(the(\x. brown(x) and block(x)), left(the(\x. brown(x) and block(x)))))"},
    {"move those two cups to the left of the plate", R"(put(those(\x. cup(x)), left(the(\x. plate(x)))))"},
    {"rotate the bowl", R"(turn(the(\x. bowl(x))))"},
    {"could you point to the smallest ball", R"(point(the(\x. smallest(\y. ball(y), x))))"},
    {"which cup is in front of the plate",
     R"(which(\x. cup(x) and located(x, in_front(the(\y. plate(y))))))"},
    {"where are the green blocks", R"(where(all(\x. green(x) and block(x))))"},
    {"what is this", R"(what(this(\x. true)))"},
    {"what's next to the bowl", R"(which(\x. located(x, beside(the(\y. bowl(y))))))"},
    {"the third ball from the right", R"(the(\x. ordinal(3, \y. offset(y, 'left'), \y. ball(y), x)))"},
    {"the rightmost red cup", R"(the(\x. rightmost(\y. red(y) and cup(y), x)))"},
    {"the block nearest the ball", R"(the(\x. closest_to(the(\y. ball(y)), \y. block(y), x)))"},
    {"another plate", R"(another(\x. plate(x)))"},
    {"put another block on this one", R"(put(another(\x. block(x)), on(this(\x. one(x)))))"},
    {"put the other cup there", R"(put(the(\x. other(x) and cup(x)), there))"},
    {"take the spoon out of the cup", R"(grasp(the(\x. spoon(x) and located(x, in(the(\y. cup(y)))))))"},
    {"grab the ball and drop it in the bowl", R"(grasp(the(\x. ball(x))); put(it, in(the(\x. bowl(x)))))"},
    {"hold on, not that one, the blue one", R"(wait; no; the(\x. blue(x) and one(x)))"},
    {"okay now put the red cube on top of the green cube",
     R"(yes; put(the(\x. red(x) and block(x)), on(the(\x. green(x) and block(x)))))"},
    {"put the fork, the knife and the spoon on the plate",
     R"(put([the(\x. fork(x)), the(\x. knife(x)), the(\x. spoon(x))], on(the(\x. plate(x)))))"},
    {"the blue block left of the cup, in front of the plate and touching the red block",
     R"(the(\x. blue(x) and block(x) and located(x, left(the(\y. cup(y)))) and located(x, in_front(the(\y. plate(y)))) and located(x, touching(the(\y. red(y) and block(y))))))"},
    {"that ball behind and touching the book",
     R"(that(\x. ball(x) and located(x, behind(the(\y. book(y)))) and located(x, touching(the(\y. book(y))))))"},
    {"put the ball in the cup on the left",
     R"(put(the(\x. ball(x)), in(the(\x. leftmost(\y. cup(y), x)))))"},
    {"bring me that bottle", R"(put(that(\x. bottle(x)), near(me)))"},
    {"hand the fork to me", R"(put(the(\x. fork(x)), near(me)))"},
    {"show me both knives", R"(point(both(\x. knife(x))))"},
    {"pick the little ball up", R"(lift(the(\x. small(\y. ball(y), x))))"},
    {"pick up the cup that is behind the bottle",
     R"(lift(the(\x. cup(x) and located(x, behind(the(\y. bottle(y)))))))"},
    {"move this over there", R"(put(this(\x. true), there))"},
    {"put it", R"(\v. put(it, v))"},
    {"grasp", R"(\x. grasp(x))"},
    {"push the ball", R"(\v. slide(the(\x. ball(x)), v))"},
    {"place beside the bottle", R"(\x. put(x, beside(the(\y. bottle(y)))))"},
    {"put here", R"(\x. put(x, here))"},
    {"turn", R"(\x. turn(x))"},
    {"the gray one behind the other gray one",
     R"(the(\x. gray(x) and one(x) and located(x, behind(the(\y. other(y) and gray(y) and one(y))))))"},
    {"four yellow balls", R"(four(\x. yellow(x) and ball(x)))"},
    {"all the bowls", R"(all(\x. bowl(x)))"},
    {"them", "them"},
    {"in front of the bowl and the cup", R"(in_front([the(\x. bowl(x)), the(\x. cup(x))]))"},
    {"forget it", "never_mind"},
    {"hang on", "wait"},
    {"keep going", "go_on"},
    {"hi there could you grab the glass bottle", R"(hello; grasp(the(\x. glass(x) and bottle(x))))"},
    {"put the fragile vase behind the plate thanks", R"(\x. put(x, behind(the(\y. plate(y)))); thanks)"},
    {"I would like you to slide the silver spoon toward the edge of the plate",
     R"(slide(the(\x. silver(x) and spoon(x)), near(the(\x. plate(x)))))"},
    {"on the plate place the cup", R"(put(the(\x. cup(x)), on(the(\x. plate(x)))))"},
    {"is the fork in the cup", R"(whether(located(the(\x. fork(x)), in(the(\x. cup(x))))))"},
    {"don't touch the cup", "no"},
    {"look at the red thing", R"(look_at(the(\x. red(x))))"},
    {"the middle cup", R"(the(\x. middle(\y. cup(y), x)))"},
    {"stop. Put the cup down.", R"(stop; ungrasp(the(\x. cup(x))))"},
};

}  // namespace

TEST_CASE("sentences are read as expected") {
  for (const auto& [text, reading] : sentences) {
    CAPTURE(text);
    CHECK(reading_of(text) == reading);
  }
}
