#pragma once
#include <memory>
#include <nanoflann.hpp>

#include "bench/photon_clouds.hpp"

namespace cardioid::bench {

/// nanoflann over the photons' positions, as a yardstick; its defaults but for leaves of 32, which are quicker here.
class NanoMap {
public:
    explicit NanoMap(const PhotonCloud& cloud)
        : points_(std::make_unique<Points>(Points{cloud.photons})),
          tree_(std::make_unique<Tree>(3, *points_, nanoflann::KDTreeSingleIndexAdaptorParams(32))) {}

    std::uint32_t nearest(Vec3 p, std::uint32_t k) {
        nanoflann::KNNResultSet<float, std::uint32_t> result(k);
        result.init(index_, d2_);
        tree_->findNeighbors(result, &p.x, nanoflann::SearchParams());
        return static_cast<std::uint32_t>(result.size());
    }
    std::uint32_t one(Vec3 p) {
        nearest(p, 1);
        return index_[0];
    }
    std::uint32_t within(Vec3 p, float radius) {
        /// Counts what it is told of.
        struct Count {
            float most_d2;
            std::uint32_t count = 0;
            [[nodiscard]] std::size_t size() const { return count; }
            [[nodiscard]] bool full() const { return true; }
            bool addPoint(float d2, std::uint32_t /*index*/) {
                count += d2 < most_d2;
                return true;
            }
            [[nodiscard]] float worstDist() const { return most_d2; }
        } count{radius * radius};
        tree_->findNeighbors(count, &p.x, nanoflann::SearchParams());
        return count.count;
    }

private:
    /// What nanoflann asks of a set of points, by its own names.
    struct Points {
        std::vector<photon::Photon> photons;
        [[nodiscard]] std::size_t kdtree_get_point_count() const { return photons.size(); }
        [[nodiscard]] float kdtree_get_pt(std::size_t i, std::size_t axis) const {
            return photons[i].p[static_cast<int>(axis)];
        }
        template <class Box>
        bool kdtree_get_bbox(Box& /*box*/) const {
            return false;
        }
    };
    using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Points>, Points, 3>;

    std::unique_ptr<Points> points_;
    std::unique_ptr<Tree> tree_;
    std::uint32_t index_[1024];
    float d2_[1024];
};

}  // namespace cardioid::bench
