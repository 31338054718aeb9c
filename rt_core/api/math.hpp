#pragma once
/// The vocabulary of every hook: vectors, colours, frames, sampling. Part of what a plug-in may include.
#include "rt_core/math/affine.hpp"
#include "rt_core/math/box.hpp"
#include "rt_core/math/fill_samples.hpp"
#include "rt_core/math/frame.hpp"
#include "rt_core/math/rgb.hpp"
#include "rt_core/math/sampler.hpp"
#include "rt_core/math/sampling.hpp"
#include "rt_core/math/vec.hpp"
