/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "testCatch.H"
#include "testCase.H"
#include "surfaceKernel.H"
#include <Eigen/SparseCholesky>

using namespace Foam;

TEST_CASE("surface kernels: sum and first moment at any place", "[membrane][serial]")
{
    for (const word name : {"hat", "threePoint", "fourPoint"})
    {
        INFO(name);
        const surfaceKernel K(dictOf("kernel " + name + ";"));
        for (scalar y = 0; y < 1; y += 0.07)
        {
            scalar zeroth = 0;
            scalar first = 0;
            for (label c = -4; c <= 4; ++c)
            {
                zeroth += K(c - y);
                first += K(c - y)*(c - y);
            }
            CHECK(zeroth == Approx(1).epsilon(1e-12));
            CHECK(mag(first) < 1e-12);
        }
    }

    // Of the hat, whose sums are polynomials: means of y (1 - y) and 2 y (1 - y)
    const surfaceKernel hat(surfaceKernel::form::hat);
    CHECK(hat.variance() == Approx(1.0/6).epsilon(1e-4));
    CHECK(hat.meanDistance(vector(1, 0, 0)) == Approx(1.0/3).epsilon(1e-4));
}


TEST_CASE("surface kernels: the integral of the kernel", "[membrane][serial]")
{
    for (const word name : {"hat", "threePoint", "fourPoint"})
    {
        INFO(name);
        const surfaceKernel K(dictOf("kernel " + name + ";"));
        CHECK(K.beyond(0) == Approx(0.5));
        CHECK(K.beyond(-3) == 1);
        CHECK(K.beyond(3) == 0);
        const scalar h = 0.02;
        for (scalar r = -1.9; r < 1.9; r += 0.13)
        {
            CHECK(K.beyond(r) + K.beyond(-r) == Approx(1));
            CHECK
            (
                (K.beyond(r - h) - K.beyond(r + h))/(2*h)
             == Approx(K(r)).margin(0.02)
            );
        }
    }
}


TEST_CASE("surface kernels: what a layer lacks beside a sharp surface", "[membrane][serial]")
{
    for (const word name : {"hat", "threePoint", "fourPoint"})
    {
        INFO(name);
        const surfaceKernel K(dictOf("kernel " + name + ";"));
        CHECK(mag(K.deficit(1)) < 1e-12);
        CHECK(K.deficit(20) > K.deficit(5));

        // The same layer from either side, and of nearly equal fluids
        CHECK(K.deficit(5) == Approx(5*K.deficit(0.2)));
        scalar both = 0;
        for (scalar r = -2; r < 2; r += 0.01)
        {
            both += 0.01*K.beyond(r)*(1 - K.beyond(r));
        }
        CHECK(K.deficit(1.01) == Approx(1e-4*both).epsilon(0.02));
    }

    // Of hat 7/24, of threePoint from another program
    const vector n(0, 1, 0);
    CHECK
    (
        surfaceKernel(dictOf("kernel hat;")).overlap(n) == Approx(7.0/24).epsilon(1e-4)
    );
    CHECK
    (
        surfaceKernel(dictOf("kernel threePoint;")).overlap(n)
     == Approx(0.354386).epsilon(1e-4)
    );
}


TEST_CASE("surface kernels: a plane at any angle to the mesh", "[membrane][serial]")
{
    // Planes through a square mesh with +1 and -1 as forces along them, periodic; their
    // velocities differ by less than those of sharp ones by the mean distance
    const label nx = 60;
    const label ny = GENERATE(15, 30, 45, 60);
    const auto name = GENERATE("hat", "threePoint", "fourPoint");
    INFO(name << " " << scalar(ny)/nx);
    const surfaceKernel K(dictOf(string("kernel ") + name + ";"));
    const vector n(normalised(vector(-ny, nx, 0)));
    const auto cell = [&](label i, label j)
    {
        return (i + nx) % nx + nx*((j + 2*ny) % ny);
    };

    std::vector<Eigen::Triplet<double>> entries;
    for (label i = 0; i < nx; ++i)
    {
        for (label j = 0; j < ny; ++j)
        {
            const label c = cell(i, j);
            entries.emplace_back(c, c, 4 + (c == 0));
            for (const label d :
                {cell(i + 1, j), cell(i - 1, j), cell(i, j + 1), cell(i, j - 1)})
            {
                entries.emplace_back(c, d, -1);
            }
        }
    }
    Eigen::SparseMatrix<double> A(nx*ny, nx*ny);
    A.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> laplacian(A);

    // Mean over the places of the planes in the mesh, and along them
    const label nPlaces = 10;
    scalar meanDistance = 0;
    for (label place = 0; place < nPlaces; ++place)
    {
        Eigen::VectorXd weights = Eigen::VectorXd::Zero(nx*ny);
        const label nNodes = 10*nx;
        for (label k = 0; k < nNodes; ++k)
        {
            for (const label side : {0, 1})
            {
                const scalar x = (k + 0.5)*nx/nNodes;
                const scalar y =
                    (k + 0.5)*ny/nNodes + (place + 0.5)/nPlaces + 0.5*side*ny;
                for (label i = label(x) - 2; i < x + 2; ++i)
                {
                    for (label j = label(y) - 2; j < y + 2; ++j)
                    {
                        weights[cell(i, j)] +=
                            (side ? -1.0 : 1.0)*K(i - x)*K(j - y)/nNodes;
                    }
                }
            }
        }
        const scalar length = Foam::hypot(scalar(nx), scalar(ny));
        const Eigen::VectorXd u = laplacian.solve(length*weights);
        meanDistance += (0.5*ny*n.y()*0.5 - weights.dot(u))/nPlaces;
    }
    CHECK(K.meanDistance(n) == Approx(meanDistance).epsilon(0.015));
}
