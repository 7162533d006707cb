// The engine in one header: knowledge from files, a body, and a conversation with them.
//
//   const auto data = continua::data_paths_of(CONTINUA_DATA_DIR);
//   const auto parts = continua::load_engine_parts("interaction", *data);
//   continua::KinematicBody body(world);
//   continua::Conversation conversation(*parts, body);
//
// examples/embed is a whole program. simulation/ (MuJoCo) has headers of its own.
#pragma once

#include "continua/body/body.h"
#include "continua/body/kinematic_body.h"
#include "continua/conversation/conversation.h"
#include "continua/core/result.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/knowledge_files/engine_parts.h"
#include "continua/learning/learning.h"
#include "continua/perception/input_event.h"
#include "continua/term/term_text.h"
#include "continua/world/world_snapshot.h"
