// Contacts between boxes, as the guard leaves them.
#include "continua/simulation/box_contacts.h"

#include <string>

#include "continua/simulation/mujoco_model.h"
#include "support/catch.h"

using namespace continua;

TEST_CASE("a block over the table's edge stands on all corners of what they share, however little it leans") {
  guard_box_contacts();
  for (const char* lean : {"0.000017 0.000003", "0.00002 -0.00001", "-0.00002 0.00001", "0.00004 0", "0 0"}) {
    INFO(lean);
    const auto made = compile_mjcf(
        "<mujoco><worldbody><geom type='box' size='0.5 0.1168 0.012' pos='0 0 -0.012'/>"
        "<body pos='0.15 -0.0967 0.029995' quat='1 " +
            std::string(lean) +
            " 0.000026'><freejoint/><geom type='box' size='0.03 0.03 0.03'/></body>"
            "</worldbody></mujoco>",
        "");
    const ModelOwner& model = std::get<ModelOwner>(made);
    const DataOwner data(mj_makeData(model.get()));
    mj_forward(model.get(), data.get());
    CHECK(data->ncon >= 4);
    for (int i = 0; i < data->ncon; ++i) CHECK(std::abs(data->contact[i].dist) < 2e-5);
  }
}
