// The HTTP library. Its headers make `_res` a macro (<resolv.h>), which is the name of a type's parameter in Eigen.
#pragma once

#include <httplib.h>

#undef _res
