// Ends of acts as inputs, and the words of the avatar about them.
#include "continua/pipeline/acting.h"

#include "continua/automaton/stepper.h"
#include "continua/facts/world_facts.h"
#include "continua/knowledge_files/language_loading.h"
#include "support/catch.h"

using namespace continua;

namespace {

Term constant(const char* name) { return Term::constant(name, Type::term()); }

/// A table with a blue cup, a red cup and a plate.
WorldSnapshot world_with_cups() {
  WorldSnapshot world;
  world.table = {{-0.6, -0.4, 0}, {0.6, 0.4, 0}};
  const auto add = [&](const char* name, const char* type, const char* color, double x) {
    ObjectState object;
    object.name = name;
    object.attributes = {{"type", type}, {"color", color}};
    object.half_extents_m = {0.03, 0.03, 0.03};
    object.p_WO = on_grid({x, 0, 0.03});
    world.objects.push_back(object);
  };
  add("cup_1", "cup", "blue", -0.3);
  add("cup_2", "cup", "red", 0);
  add("plate_1", "plate", "white", 0.3);
  return world;
}

class Talk {
 public:
  explicit Talk(const std::string& language) : facts_(Perspective::human) {
    const auto data = find_data_paths();
    if (!data) FAIL(data.error().text());
    auto machine = load_machine((data->knowledge / "machines/interaction.json").string(), *data, language);
    if (!machine) FAIL(machine.error().text());
    machine_ = std::make_shared<const Machine>(*std::move(machine));
  }

  /// The words about put(cup_1, left(plate_1)) after its end for that reason.
  std::string about(const Reason& reason) {
    ActEnd end;
    end.act.program = Term::apply(Term::apply(constant("put"), Term::entity("cup_1")),
                                  Term::apply(constant("left"), Term::entity("plate_1")));
    // Acts that are done are not talked about.
    end.status = status_of(reason.code) == ActStatus::done ? ActStatus::blocked : status_of(reason.code);
    end.reason = reason;
    const Stepper stepper(machine_, facts_.rules());
    const Beliefs beliefs(machine_->beliefs);
    const Facts facts{.world = &world_, .beliefs = &beliefs};
    Chooser chooser{machine_->choice, Random(1), {}, 0};
    const auto begun = stepper.begin(facts, chooser);
    const auto step = stepper.step(begun.after, to_input(end, 1, SimTime{}), facts, chooser);
    std::string words;
    for (const auto& event : step.events)
      if (const auto* said = std::get_if<Said>(&event)) words += said->text;
    return words;
  }

 private:
  WorldSnapshot world_ = world_with_cups();
  WorldFacts facts_;
  std::shared_ptr<const Machine> machine_;
};

}  // namespace

TEST_CASE("the end of an act tells its program, the code of its reason and the objects concerned") {
  ActEnd end;
  end.act = {3, constant("stop"), {1, 2}};
  end.status = ActStatus::dropped;
  end.reason = {ReasonCode::slipped, {"cup_1"}};
  const Input input = to_input(end, 7, SimTime::from_seconds(2));
  CHECK(input.serial == 7);
  CHECK(input.because == std::vector<int>{1, 2});
  CHECK(input.symbol == "act dropped");
  CHECK(input.act == constant("stop"));
  CHECK(input.why == Term::text("slipped"));
  CHECK(input.concerned == Term::list({Term::entity("cup_1")}, Type::entity()));
  CHECK(input.reason == Term::text("cup_1 slipped out of the fingers"));
  end.reason = {};
  CHECK(to_input(end, 8, SimTime{}).why.is_null());
}

TEST_CASE("the avatar words a reason in its language, and names objects as people do") {
  struct Row {
    Reason reason;
    std::string english, german;
  };
  const Row rows[] = {
      {{ReasonCode::slipped, {"cup_1"}},
       "I could not do it: the blue cup slipped out of my fingers.",
       "Das ist mir nicht gelungen: Die blaue Tasse ist mir aus den Fingern gerutscht."},
      {{ReasonCode::in_the_way, {"cup_2", "cup_1"}},
       "I could not do it: the red cup is in the way of the blue cup.",
       "Das ist mir nicht gelungen: Die rote Tasse versperrt den Weg für die blaue Tasse."},
      {{ReasonCode::no_room, {"cup_1", "plate_1"}, {"left"}},
       "I could not do it: there is no room for the blue cup left of the white plate.",
       "Das ist mir nicht gelungen: Für die blaue Tasse ist dort kein Platz."},
      {{}, "I could not do it.", "Das ist mir nicht gelungen."},
  };
  for (const auto& row : rows) {
    CHECK(Talk("english").about(row.reason) == row.english);
    CHECK(Talk("german").about(row.reason) == row.german);
  }
}

TEST_CASE("every language says a sentence for every code") {
  for (const auto* language : {"english", "german"}) {
    Talk talk(language);
    const auto without = talk.about({});
    for (const auto code : all_reasons()) {
      const auto words = talk.about({code, {"cup_1", "plate_1"}});
      INFO(language << ", " << name_of(code) << ": " << words);
      CHECK(words.size() > without.size() + 5);
      CHECK(words.find('_') == std::string::npos);
      CHECK(words.find("null") == std::string::npos);
    }
  }
}
