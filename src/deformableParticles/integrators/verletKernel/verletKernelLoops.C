/*---------------------------------------------------------------------------*\
    deformableParticles: deformable particles for OpenFOAM
    GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "verletKernelLoops.H"
#include <algorithm>
#include <cmath>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
    #define anyProcessor                                                      \
        __attribute__((target_clones("arch=haswell", "default"),              \
        optimize("no-math-errno", "no-trapping-math")))
    #define independent _Pragma("GCC ivdep")
#else
    #define anyProcessor
    #define independent
#endif

namespace Foam
{
namespace verletLoops
{

// x/sin(x) = 1 + t g(t), t = sin^2(x/2): coefficients of g, a_k = a_(k-1) 2k/(2k+1)
static const double a1 = 2.0/3.0, a2 = a1*4/5, a3 = a2*6/7, a4 = a3*8/9,
    a5 = a4*10/11, a6 = a5*12/13, a7 = a6*14/15, a8 = a7*16/17, a9 = a8*18/19;


anyProcessor void frames(layout& a)
{
    const int n = a.nBonds;
    const int* i = a.i;
    const int* j = a.j;

    independent
    for (int b = 0; b < n; ++b)
    {
        const double aw = a.q[0][i[b]], ax = a.q[1][i[b]], ay = a.q[2][i[b]],
            az = a.q[3][i[b]];
        const double bw = a.q[0][j[b]], bx = a.q[1][j[b]], by = a.q[2][j[b]],
            bz = a.q[3][j[b]];

        const double dot = aw*bw + ax*bx + ay*by + az*bz;
        const double s = dot < 0 ? -1 : 1;
        const double w = s*dot;
        const double vx = s*(aw*bx - bw*ax - (ay*bz - az*by));
        const double vy = s*(aw*by - bw*ay - (az*bx - ax*bz));
        const double vz = s*(aw*bz - bw*az - (ax*by - ay*bx));
        const double s2 = vx*vx + vy*vy + vz*vz;
        const double t = 0.5*s2/(1 + w);

        const double g = a1 + t*(a2 + t*(a3 + t*(a4 + t*(a5 + t*(a6
          + t*(a7 + t*(a8 + t*a9)))))));

        a.v[0][b] = vx;
        a.v[1][b] = vy;
        a.v[2][b] = vz;
        a.cosHalf[b] = w;
        a.sin2[b] = t;
        a.g[b] = g;
        a.h[b] = 1 + t*g;

        // The mean rotation, not normalised
        a.sum[0][b] = aw + s*bw;
        a.sum[1][b] = ax + s*bx;
        a.sum[2][b] = ay + s*by;
        a.sum[3][b] = az + s*bz;

        const double dx = a.x[0][j[b]] - a.x[0][i[b]];
        const double dy = a.x[1][j[b]] - a.x[1][i[b]];
        const double dz = a.x[2][j[b]] - a.x[2][i[b]];
        a.d[0][b] = dx;
        a.d[1][b] = dy;
        a.d[2][b] = dz;
        a.distance[b] = std::sqrt(dx*dx + dy*dy + dz*dz);
        a.N[b] = a.kn[b]*(a.distance[b] - a.length[b]);
    }
}


double largestTurn(const layout& a)
{
    double result = 0;
    for (int b = 0; b < a.nBonds; ++b)
    {
        result = std::max(result, a.sin2[b]);
    }
    return result;
}


void largeTurns(layout& a)
{
    for (int b = 0; b < a.nBonds; ++b)
    {
        const double t = a.sin2[b];
        if (t > seriesLimit)
        {
            const double half = 2*std::asin(std::sqrt(std::min(t, 1.0)));
            a.h[b] = half/std::sin(half);
            a.g[b] = (a.h[b] - 1)/t;
        }
    }
}


namespace
{

template<bool Damped>
inline __attribute__((always_inline)) void bondForcesOf(layout& a)
{
    const int n = a.nBonds;
    const int* i = a.i;
    const int* j = a.j;

    independent
    for (int b = 0; b < n; ++b)
    {
        // Rotation of the bond's frame
        const double w = a.cosHalf[b];
        const double oneBy = 1/(1 + w);
        const double q0 = a.sum[0][b], qx = a.sum[1][b], qy = a.sum[2][b],
            qz = a.sum[3][b];

        // By their own length, not 2(1 + w): orthogonal to rounding, or angular
        // momentum would drift with the rounding of the orientations
        const double n2 = 2/(q0*q0 + qx*qx + qy*qy + qz*qz);
        const double rxx = 1 - n2*(qy*qy + qz*qz);
        const double rxy = n2*(qx*qy - q0*qz);
        const double rxz = n2*(qx*qz + q0*qy);
        const double ryx = n2*(qx*qy + q0*qz);
        const double ryy = 1 - n2*(qx*qx + qz*qz);
        const double ryz = n2*(qy*qz - q0*qx);
        const double rzx = n2*(qx*qz - q0*qy);
        const double rzy = n2*(qy*qz + q0*qx);
        const double rzz = 1 - n2*(qx*qx + qy*qy);

        const double Dx = a.d[0][b], Dy = a.d[1][b], Dz = a.d[2][b];
        const double dx = rxx*Dx + ryx*Dy + rzx*Dz;
        const double dy = rxy*Dx + ryy*Dy + rzy*Dz;
        const double dz = rxz*Dx + ryz*Dy + rzz*Dz;

        // Maps of relative rotation
        const double h = a.h[b];
        const double oneByH = 1/h;
        const double px = 2*h*a.v[0][b], py = 2*h*a.v[1][b], pz = 2*h*a.v[2][b];
        const double c = -0.25*oneByH*oneBy;
        const double k = -0.125*a.g[b]*oneByH*oneByH*oneBy;

        // Law
        const double ex = a.e[0][b], ey = a.e[1][b], ez = a.e[2][b];
        const double shear = a.shear[b];
        const double oneByD = 1/std::max(a.distance[b], 1e-12*a.length[b]);
        const double along = (a.N[b] + shear)*oneByD;
        double nx = along*dx - shear*ex + a.n0[0][b];
        double ny = along*dy - shear*ey + a.n0[1][b];
        double nz = along*dz - shear*ez + a.n0[2][b];
        const double kb = a.kb[b];
        const double turn = (a.kt[b] - kb)*(px*ex + py*ey + pz*ez);
        double mx = kb*px + turn*ex + a.m0[0][b];
        double my = kb*py + turn*ey + a.m0[1][b];
        double mz = kb*pz + turn*ez + a.m0[2][b];

        if (Damped)
        {
            const double Ux = a.u[0][j[b]] - a.u[0][i[b]];
            const double Uy = a.u[1][j[b]] - a.u[1][i[b]];
            const double Uz = a.u[2][j[b]] - a.u[2][i[b]];
            const double Rx = a.w[0][j[b]] - a.w[0][i[b]];
            const double Ry = a.w[1][j[b]] - a.w[1][i[b]];
            const double Rz = a.w[2][j[b]] - a.w[2][i[b]];
            const double Sx = 0.5*(a.w[0][j[b]] + a.w[0][i[b]]);
            const double Sy = 0.5*(a.w[1][j[b]] + a.w[1][i[b]]);
            const double Sz = 0.5*(a.w[2][j[b]] + a.w[2][i[b]]);

            const double ux = rxx*Ux + ryx*Uy + rzx*Uz;
            const double uy = rxy*Ux + ryy*Uy + rzy*Uz;
            const double uz = rxz*Ux + ryz*Uy + rzz*Uz;
            const double rx = rxx*Rx + ryx*Ry + rzx*Rz;
            const double ry = rxy*Rx + ryy*Ry + rzy*Rz;
            const double rz = rxz*Rx + ryz*Ry + rzz*Rz;

            const double sx = rxx*Sx + ryx*Sy + rzx*Sz + c*(py*rz - pz*ry);
            const double sy = rxy*Sx + ryy*Sy + rzy*Sz + c*(pz*rx - px*rz);
            const double sz = rxz*Sx + ryz*Sy + rzz*Sz + c*(px*ry - py*rx);

            const double gx = ux - (sy*dz - sz*dy);
            const double gy = uy - (sz*dx - sx*dz);
            const double gz = uz - (sx*dy - sy*dx);
            const double cs = a.cs[b];
            const double gt =
                (a.cn[b] - cs)*(gx*dx + gy*dy + gz*dz)*oneByD*oneByD;
            nx += cs*gx + gt*dx;
            ny += cs*gy + gt*dy;
            nz += cs*gz + gt*dz;

            const double pr = k*(px*rx + py*ry + pz*rz);
            const double tx = h*rx + pr*px;
            const double ty = h*ry + pr*py;
            const double tz = h*rz + pr*pz;
            const double cb = a.cb[b];
            const double te = (a.ct[b] - cb)*(tx*ex + ty*ey + tz*ez);
            mx += cb*tx + te*ex;
            my += cb*ty + te*ey;
            mz += cb*tz + te*ez;
        }

        // To the spheres
        const double Wx = dy*nz - dz*ny;
        const double Wy = dz*nx - dx*nz;
        const double Wz = dx*ny - dy*nx;
        const double pm = k*(px*mx + py*my + pz*mz);
        const double Cx = c*(py*Wz - pz*Wy) + h*mx + pm*px;
        const double Cy = c*(pz*Wx - px*Wz) + h*my + pm*py;
        const double Cz = c*(px*Wy - py*Wx) + h*mz + pm*pz;

        a.fn[0][b] = rxx*nx + rxy*ny + rxz*nz;
        a.fn[1][b] = ryx*nx + ryy*ny + ryz*nz;
        a.fn[2][b] = rzx*nx + rzy*ny + rzz*nz;

        const double hx = 0.5*(rxx*Wx + rxy*Wy + rxz*Wz);
        const double hy = 0.5*(ryx*Wx + ryy*Wy + ryz*Wz);
        const double hz = 0.5*(rzx*Wx + rzy*Wy + rzz*Wz);
        const double cx = rxx*Cx + rxy*Cy + rxz*Cz;
        const double cy = ryx*Cx + ryy*Cy + ryz*Cz;
        const double cz = rzx*Cx + rzy*Cy + rzz*Cz;
        a.ti[0][b] = hx + cx;
        a.ti[1][b] = hy + cy;
        a.ti[2][b] = hz + cz;
        a.tj[0][b] = hx - cx;
        a.tj[1][b] = hy - cy;
        a.tj[2][b] = hz - cz;
    }

    for (int c = 0; c < 3; ++c)
    {
        for (int s = 0; s < a.nSpheres; ++s)
        {
            a.F[c][s] = a.f[c][s];
            a.T[c][s] = a.t[c][s];
        }

        // First ends, then second ones: neighbours in a chain do not wait for
        // each other
        double* F = a.F[c];
        double* T = a.T[c];
        const double* f = a.fn[c];
        const double* ti = a.ti[c];
        const double* tj = a.tj[c];
        for (int b = 0; b < n; ++b)
        {
            F[i[b]] += f[b];
            T[i[b]] += ti[b];
        }
        for (int b = 0; b < n; ++b)
        {
            F[j[b]] -= f[b];
            T[j[b]] += tj[b];
        }
    }
}

}


anyProcessor void elasticForces(layout& a)
{
    bondForcesOf<false>(a);
}


anyProcessor void dampedForces(layout& a)
{
    bondForcesOf<true>(a);
}


anyProcessor void exchange(layout& a)
{
    // Rows of the symmetric tensor xx xy xz yy yz zz
    static const int row[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

    for (int c = 0; c < 3; ++c)
    {
        independent
        for (int s = 0; s < a.nSpheres; ++s)
        {
            double f = a.zeta[s]*(a.u[c][s] - a.u0[c][s]);
            for (int d = 0; d < 3; ++d)
            {
                f += a.k[row[c][d]][s]*(a.x[d][s] - a.x0[d][s]);
            }
            a.F[c][s] -= f;
            a.T[c][s] -= a.zetaR[s]*(a.w[c][s] - a.w0[c][s]);
        }
    }
}


anyProcessor void kick(layout& a, const double h)
{
    for (int c = 0; c < 3; ++c)
    {
        independent
        for (int s = 0; s < a.nSpheres; ++s)
        {
            a.u[c][s] += 0.5*h*a.oneByM[s]*a.F[c][s];
            a.w[c][s] += 0.5*h*a.oneByI[s]*a.T[c][s];
        }
    }
}


anyProcessor void kickAndDrift(layout& a, const double h)
{
    kick(a, h);

    independent
    for (int s = 0; s < a.nSpheres; ++s)
    {
        a.x[0][s] += h*a.u[0][s];
        a.x[1][s] += h*a.u[1][s];
        a.x[2][s] += h*a.u[2][s];

        // Half the rotation of the step, by Cayley's map: second order, and as
        // long as it is small the rotation vector to h^3
        const double bx = 0.5*h*a.w[0][s], by = 0.5*h*a.w[1][s],
            bz = 0.5*h*a.w[2][s];
        const double b2 = bx*bx + by*by + bz*bz;
        const double r = 1/std::sqrt(1 + b2);
        const double rx = r*bx, ry = r*by, rz = r*bz;

        const double w = a.q[0][s], x = a.q[1][s], y = a.q[2][s], z = a.q[3][s];
        const double W = r*w - rx*x - ry*y - rz*z;
        const double X = r*x + rx*w + ry*z - rz*y;
        const double Y = r*y + ry*w + rz*x - rx*z;
        const double Z = r*z + rz*w + rx*y - ry*x;

        // Keeps the length one
        const double n = 1.5 - 0.5*(W*W + X*X + Y*Y + Z*Z);
        a.q[0][s] = n*W;
        a.q[1][s] = n*X;
        a.q[2][s] = n*Y;
        a.q[3][s] = n*Z;
    }
}

}
}
