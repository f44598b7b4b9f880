// clang-format off
// Generated from symbolic formulas by sympy (common subexpressions taken out), checked by finite differences.
#pragma once

#include <cmath>

/// Manufactured solutions of a St. Venant-Kirchhoff body, plane strain, unit square:
/// d_1 = A sin(pi X / 2) cos(pi Y), d_2 = A cos(pi X) sin(pi Y / 2 + 1/5) + A X^2, in d2_dyn times cos(2 pi t);
/// P = F S row by row, shape (2, 2); f = rho d_tt - Div P is the force per reference volume.
namespace mms_svk
{

inline void d2_static(const double*x,double t,double lambda,double mu,double rho,double A,double*d,double*P,double*f){
  const double X=x[0], Y=x[1]; (void)t;(void)rho;
  const double x0=M_PI*X;
  const double x1=(1.0/2.0)*x0;
  const double x2=sin(x1);
  const double x3=M_PI*Y;
  const double x4=cos(x3);
  const double x5=A*x4;
  const double x6=cos(x0);
  const double x7=(1.0/2.0)*x3 + 1.0/5.0;
  const double x8=sin(x7);
  const double x9=x6*x8;
  const double x10=sin(x3);
  const double x11=M_PI*x10;
  const double x12=pow(A, 2);
  const double x13=cos(x1);
  const double x14=M_PI*x13;
  const double x15=x14*x5 + 2;
  const double x16=cos(x7);
  const double x17=M_PI*A;
  const double x18=x16*x17*x6 + 2;
  const double x19=sin(x0);
  const double x20=2*X - M_PI*x19*x8;
  const double x21=M_PI*x10*x15*x2 - x18*x20;
  const double x22=mu*x21;
  const double x23=8*x12*x22;
  const double x24=4*x12;
  const double x25=pow(x15, 2) + pow(x20, 2)*x24;
  const double x26=2*mu;
  const double x27=pow(M_PI, 2);
  const double x28=pow(x10, 2);
  const double x29=pow(x2, 2);
  const double x30=pow(x18, 2) + x24*x27*x28*x29;
  const double x31=lambda*(x25 + x30 - 8);
  const double x32=x26*(x25 - 4) + x31;
  const double x33=x21*x26;
  const double x34=x26*(x30 - 4) + x31;
  const double x35=x2*x34;
  const double x36=(1.0/8.0)*A;
  const double x37=x10*x13;
  const double x38=16*A*x22*x27;
  const double x39=A*x2*x28;
  const double x40=2*x15;
  const double x41=x16*x19;
  const double x42=x18*x41;
  const double x43=A*x20;
  const double x44=-2*x14*x39 + x2*x4*x40 + x42 + x43*x9;
  const double x45=x15*x27;
  const double x46=4*mu;
  const double x47=x29*x5;
  const double x48=pow(M_PI, 3);
  const double x49=x10*x48;
  const double x50=x27*x9 - 2;
  const double x51=2*x18;
  const double x52=2*x27;
  const double x53=x37*x45 + x41*x43*x52 - x47*x49 + x50*x51;
  const double x54=x27*x4;
  const double x55=8*x11*x47;
  const double x56=x18*x9;
  const double x57=4*x43;
  const double x58=lambda*(x37*x40 + x41*x57 - x55 + x56) - x26*(x55 - x56);
  const double x59=x15*x2*x54;
  const double x60=8*x43;
  const double x61=x50*x60 + x59;
  const double x62=-4*x13*x39*x48 + x42*x52 + x61;
  const double x63=(1.0/32.0)*A;
  d[0]=x2*x5;
  d[1]=A*(pow(X, 2) + x9);
  P[0]=(1.0/16.0)*x11*x2*x23 + (1.0/16.0)*x15*x32;
  P[1]=-x36*(x11*x35 + x15*x33);
  P[2]=x36*(-x18*x33 + x20*x32);
  P[3]=(1.0/16.0)*x18*x34 - 1.0/16.0*x20*x23;
  f[0]=x63*(-4*A*x2*x49*x58 - 8*mu*x10*x17*x2*x53 + x2*x32*x54 + 4*x35*x54 - x37*x38 + x40*(lambda*x62 + x26*x61) + x44*x45*x46);
  f[1]=x63*(8*A*mu*x20*x27*x44 + x18*x46*x53 + x27*x34*x6*x8 + x27*x51*x58 + 4*x32*x50 - x38*x41 - x57*(-lambda*x62 - x26*(x50*x60 + x59)));
}

inline void d2_dyn(const double*x,double t,double lambda,double mu,double rho,double A,double*d,double*P,double*f){
  const double X=x[0], Y=x[1]; (void)t;(void)rho;
  const double x0=2*M_PI;
  const double x1=cos(t*x0);
  const double x2=A*x1;
  const double x3=M_PI*Y;
  const double x4=cos(x3);
  const double x5=M_PI*X;
  const double x6=(1.0/2.0)*x5;
  const double x7=sin(x6);
  const double x8=x4*x7;
  const double x9=cos(x5);
  const double x10=(1.0/2.0)*x3 + 1.0/5.0;
  const double x11=sin(x10);
  const double x12=x11*x9;
  const double x13=pow(X, 2) + x12;
  const double x14=sin(x3);
  const double x15=M_PI*x14*x7;
  const double x16=pow(A, 2)*pow(x1, 2);
  const double x17=cos(x6);
  const double x18=M_PI*x2;
  const double x19=x18*x4;
  const double x20=x17*x19 + 2;
  const double x21=sin(x5);
  const double x22=2*X - M_PI*x11*x21;
  const double x23=cos(x10);
  const double x24=x18*x23*x9 + 2;
  const double x25=M_PI*x14*x20*x7 - x22*x24;
  const double x26=mu*x25;
  const double x27=8*x16*x26;
  const double x28=4*x16;
  const double x29=pow(x20, 2) + pow(x22, 2)*x28;
  const double x30=2*mu;
  const double x31=pow(M_PI, 2);
  const double x32=pow(x14, 2);
  const double x33=pow(x7, 2);
  const double x34=pow(x24, 2) + x28*x31*x32*x33;
  const double x35=lambda*(x29 + x34 - 8);
  const double x36=x30*(x29 - 4) + x35;
  const double x37=x25*x30;
  const double x38=x30*(x34 - 4) + x35;
  const double x39=(1.0/8.0)*x2;
  const double x40=4*rho*x31;
  const double x41=(1.0/2.0)*x2*x26*x31;
  const double x42=x17*x32*x7;
  const double x43=x20*x8;
  const double x44=x21*x23;
  const double x45=x24*x44;
  const double x46=x2*x22;
  const double x47=-x0*x2*x42 + x12*x46 + 2*x43 + x45;
  const double x48=pow(M_PI, 3);
  const double x49=x2*x48;
  const double x50=x14*x33;
  const double x51=x14*x17*x20;
  const double x52=x12*x31 - 2;
  const double x53=2*x31;
  const double x54=x44*x46;
  const double x55=2*x24*x52 + x31*x51 - x4*x49*x50 + x53*x54;
  const double x56=8*x19*x50;
  const double x57=x12*x24;
  const double x58=lambda*(2*x51 + 4*x54 - x56 + x57) - x30*(x56 - x57);
  const double x59=x31*x43;
  const double x60=8*x46;
  const double x61=x52*x60 + x59;
  const double x62=-4*x42*x49 + x45*x53 + x61;
  d[0]=x2*x8;
  d[1]=x13*x2;
  P[0]=(1.0/16.0)*x15*x27 + (1.0/16.0)*x20*x36;
  P[1]=-x39*(x15*x38 + x20*x37);
  P[2]=x39*(x22*x36 - x24*x37);
  P[3]=-1.0/16.0*x22*x27 + (1.0/16.0)*x24*x38;
  f[0]=x2*(-1.0/4.0*mu*x15*x2*x55 + (1.0/8.0)*mu*x20*x31*x47 - x14*x17*x41 - x14*x39*x48*x58*x7 + (1.0/16.0)*x20*(lambda*x62 + x30*x61) + (1.0/32.0)*x31*x36*x4*x7 + (1.0/8.0)*x31*x38*x4*x7 - x40*x8);
  f[1]=x2*((1.0/4.0)*A*mu*x1*x22*x31*x47 + (1.0/8.0)*mu*x24*x55 + (1.0/32.0)*x11*x31*x38*x9 - x13*x40 - x22*x39*(-lambda*x62 - x30*(x52*x60 + x59)) + (1.0/16.0)*x24*x31*x58 + (1.0/8.0)*x36*x52 - x41*x44);
}

}  // namespace mms_svk
