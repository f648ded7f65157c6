// Batches of runs made by Slurm, for a campaign that has its runs made elsewhere.
//
//     percal::Coordinator cluster({.folder = "/shared/skin.slurm", .program = "/shared/percal", .level = percal::instruction_level()}, store);
//     campaign.have_made(cluster);
#pragma once
#include "percal/cluster/coordinator.hpp"
#include "percal/cluster/worker.hpp"
