// The acts that the arm can do in a world, judged before anything moves. The avatar asks when it decides on an act; the
// world without physics asks the same, so the two agree on the possible acts.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "continua/body/ability.h"
#include "continua/core/result.h"
#include "continua/simulation/handling.h"
#include "continua/simulation/scene.h"

namespace continua {

/// The object has a goal to be carried to, now or after the grasp.
bool has_goal(const AvatarCommand& command);

/// The goal of the act; that of the next act if the object is only grasped.
AvatarCommand with_next_goal(AvatarCommand command);

/// Whether a hand whose fingers point down gets there.
bool hand_reaches(const AvatarForm& avatar, const Vec3& p_W);

/// The task of an act that carries, lifts or holds its object; the reason if there is no place for its goal.
OrReason<Task> task_of(const AvatarCommand& command, const WorldSnapshot& world, const AvatarForm& avatar);

/// The centre of the task's object in the end.
Vec3 end_of(const Task& task, const WorldSnapshot& world);

/// The handling for the task, or the reason why there is none: the object is too wide, or it or its goal is out of
/// reach. An object within reach of some grip can be taken, whatever is done with it afterwards.
OrReason<Handling> feasible_handling(const Task& task, const WorldSnapshot& world, const Means& means,
                                     const std::optional<Grasp>& grasp, const std::vector<Grip>& tried);

/// The ability of the scene's avatar. Errors: the scene lacks an element of the avatar.
Result<std::shared_ptr<const Ability>> arm_ability(const Scene& scene);

}  // namespace continua
