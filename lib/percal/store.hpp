// store: finished evaluations on disk.
//
// SQLite, keyed by the canonical text of the dimensionless problem: what is in it is never computed again.
//
//     percal::Store store(percal::default_store_path());
//     std::cout << store.size() << " evaluations\n";
#pragma once
#include "percal/store/claims.hpp"
#include "percal/store/store.hpp"
